#include "axisc/answers/execution/recorded_axis.hpp"

#include "analysis/comparison/found_switches.hpp"
#include "analysis/comparison/residual.hpp"
#include "analysis/comparison/turns.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/byte_source.hpp"
#include "axisc/files/image_file.hpp"
#include "configuration/machine/machine.hpp"

namespace axisc::says {

constexpr Sentence name_an_axis{"{file} has {count} axes; name the recorded one with --axis",
                                "{file} hat {count} Achsen; die aufgezeichnete mit --axis nennen"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr auto translatory = static_cast<std::uint32_t>(machine::AxisType::translatory);

comparison::Configured configured(image::ImageContents const& image, std::size_t axis) {
  auto const& contents = image.axes[axis];
  comparison::Configured chain{.cycle_time = image.cycle_time, .filters = {}, .kernel = {}};
  for (auto const& filter : contents.filters) chain.filters.push_back(filter.specification);
  if (contents.slot && contents.slot->kernel) {
    chain.kernel = image.kernels[*contents.slot->kernel].specification;
    chain.kernel_on = contents.slot->on_at_start;
  }
  return chain;
}

bool agrees(comparison::Comparison const& result) {
  return result.verdict == comparison::Verdict::same || result.verdict == comparison::Verdict::delayed;
}

bool fits_nothing(comparison::Comparison const& result) {
  return result.verdict == comparison::Verdict::different && result.fitting.empty();
}

/// That of #FILTER ON and OFF without keywords.
comparison::ChangeOver change_over(image::ImageContents const& image, std::size_t axis) {
  auto const& slot = image.axes[axis].slot;
  if (!slot || !slot->group) return {};
  auto const& group = image.groups[*slot->group];
  comparison::ChangeOver lengths{.on = 0, .off = group.off_fade_cycles};
  for (auto const& bank : group.banks) {
    if (bank.parameters.empty() && bank.family() == slot->family) lengths.on = bank.fade_cycles;
  }
  return lengths;
}

/// Switches are only believed where the recording is what axisc computes with them.
void explain_by_switches(RecordedAxis& found, comparison::Configured chain,
                         comparison::ChangeOver const& lengths) {
  chain.switches = comparison::found_switches(found.columns.recording, chain, lengths);
  if (chain.switches.empty()) return;
  auto all = comparison::readings(chain);
  auto result = comparison::compare(found.columns.recording, all);
  if (!agrees(result)) return;
  found.readings = std::move(all);
  found.result = std::move(result);
  found.found_switches = std::move(chain.switches);
}

/// Of what fits; what the lists say is among it where it is the same.
std::optional<comparison::Motion> telling_motion(RecordedAxis const& found, design::CycleTime cycle_time) {
  std::vector<comparison::Reading> fitting;
  if (agrees(found.result)) fitting.push_back(found.readings.front());
  for (auto const& one : found.result.fitting) fitting.push_back(one.reading);
  constexpr double per_mm = 1000;
  constexpr double seconds_per_minute = 60;
  double const cycles_per_minute = seconds_per_minute / cycle_time.seconds();
  return comparison::telling_motion(
      fitting, found.result,
      {.velocity = telling_feed * per_mm / cycles_per_minute / found.thousandths,
       .step = telling_step * per_mm / found.thousandths});
}

}  // namespace

std::size_t recorded_axis(image::ImageContents const& image, std::optional<std::string> const& name,
                          std::string const& file) {
  auto const axes = chosen_axes(image, name);
  if (axes.size() == 1) return axes.front();
  throw Failure({says::name_an_axis, {{"file", file}, {"count", std::to_string(axes.size())}}});
}

RecordedAxis compare_axis(image::ImageContents const& image, std::size_t axis, std::string const& path,
                          WantedColumns const& columns, RecordedUnit unit,
                          std::vector<comparison::KernelSwitch> switches) {
  auto chain = configured(image, axis);
  chain.switches = std::move(switches);
  RecordedAxis found{
      .columns = read_recorded_columns(path, open_source(path), columns, image.cycle_time),
      .readings = comparison::readings(chain),
      .result = {},
      .is_guard = image.axes[axis].slot && image.axes[axis].slot->family == machine::KernelFamily::guard,
      .is_rotary = image.axes[axis].type != translatory};
  auto const& recording = found.columns.recording;
  bool const whole = is_whole(recording.input, recording.gaps) && is_whole(recording.output, recording.gaps);
  found.thousandths = thousandths_of(unit, image.axes[axis], whole);
  if (auto const range = modulo_range(image.axes[axis])) {
    found.jumps = comparison::unwind(found.columns.recording, *range / found.thousandths);
  }
  found.result = comparison::compare(found.columns.recording, found.readings);
  if (chain.switches.empty() && fits_nothing(found.result)) {
    explain_by_switches(found, std::move(chain), change_over(image, axis));
  }
  found.telling = telling_motion(found, image.cycle_time);
  return found;
}

}  // namespace axisc
