#include "cli/execution/recorded_axis.hpp"

#include "cli/failure.hpp"
#include "cli/files/byte_source.hpp"
#include "cli/files/image_file.hpp"
#include "comparison/found_switches.hpp"
#include "comparison/residual.hpp"
#include "comparison/turns.hpp"

namespace axisc::cli::says {

constexpr Sentence name_an_axis{"{file} has {count} axes; name the recorded one with --axis",
                                "{file} hat {count} Achsen; die aufgezeichnete mit --axis nennen"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr std::uint32_t rotary = 2;

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

/// Whole numbers are those of CNC objects.
RecordedUnit recognised(RecordedUnit unit, comparison::Recording const& recording) {
  if (unit != RecordedUnit::recognised) return unit;
  bool const is_whole = comparison::resolution(recording.input, recording.gaps) == 1 &&
                        comparison::resolution(recording.output, recording.gaps) == 1;
  return is_whole ? RecordedUnit::tenths : RecordedUnit::mm;
}

double thousandths(RecordedUnit unit) {
  if (unit == RecordedUnit::um) return 1;
  return unit == RecordedUnit::tenths ? 0.1 : 1000;
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
  bool const hsc = slot->family == machine::KernelFamily::hsc;
  for (auto const& bank : group.banks) {
    if (bank.parameters.empty() && bank.hsc == hsc) lengths.on = bank.fade_cycles;
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

}  // namespace

std::size_t recorded_axis(image::ImageContents const& image, std::optional<std::string> const& name,
                          std::string const& file) {
  auto const axes = chosen_axes(image, name);
  if (axes.size() == 1) return axes.front();
  throw Failure({.sentence = says::name_an_axis,
                 .arguments = {{"file", file}, {"count", std::to_string(axes.size())}}});
}

RecordedAxis compare_axis(image::ImageContents const& image, std::size_t axis, std::string const& path,
                          WantedColumns const& columns, RecordedUnit unit,
                          std::vector<comparison::KernelSwitch> switches) {
  auto chain = configured(image, axis);
  chain.switches = std::move(switches);
  RecordedAxis found{.columns = read_recorded_columns(path, open_source(path), columns, image.cycle_time),
                     .readings = comparison::readings(chain),
                     .result = {},
                     .is_rotary = image.axes[axis].type == rotary};
  found.thousandths = thousandths(recognised(unit, found.columns.recording));
  constexpr double turn = 360'000;
  if (found.is_rotary) found.jumps = comparison::unwind(found.columns.recording, turn / found.thousandths);
  found.result = comparison::compare(found.columns.recording, found.readings);
  if (chain.switches.empty() && fits_nothing(found.result)) {
    explain_by_switches(found, std::move(chain), change_over(image, axis));
  }
  return found;
}

}  // namespace axisc::cli
