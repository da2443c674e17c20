#include "axisc/answers/execution/recorded_axis.hpp"

#include "analysis/comparison/found_switches.hpp"
#include "analysis/comparison/residual.hpp"
#include "analysis/comparison/turns.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/image_file.hpp"

#include <algorithm>
#include <utility>

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

/// A list by itself does not say where the control has its axis.
AxisPlace place_of(RecordedMachine const& machine, std::size_t axis) {
  auto const& image = machine.image;
  if (machine.machine != nullptr) {
    bool const in_machine = image.axes.size() > 1 || names_machine(machine.path);
    return axis_place(*machine.machine, axis, in_machine);
  }
  AxisPlace place{.name = axis_label(image, axis)};
  if (image.axes.size() == 1) return place;
  place.number = image.axes[axis].number;
  place.index = static_cast<std::uint32_t>(axis + 1);
  for (auto const& group : image.groups) {
    auto const member = std::find(group.members.begin(), group.members.end(), axis);
    if (member == group.members.end()) continue;
    place.index = static_cast<std::uint32_t>(member - group.members.begin() + 1);
  }
  return place;
}

/// Brings both columns into one unit.
void read_positions(RecordedAxis& found, RecordingFile const& file, PositionUnits const& units,
                    image::ImageAxis const& axis) {
  auto& [input, output, gaps, first] = found.columns.recording;
  // clang 14 takes structured bindings only by name.
  auto scale_of = [&, &gaps = gaps](ChosenColumn const& column, recordings::Signal const& signal) {
    return column_scale(file, column, units, axis, signal, gaps);
  };
  auto in = scale_of(found.columns.input, input);
  auto out = scale_of(found.columns.output, output);
  // Numbers that happen to be whole have the unit of the others.
  if (in.is_guessed && out.is_guessed && in.thousandths != out.thousandths) {
    constexpr double per_mm = 1000;
    in.thousandths = per_mm;
    out.thousandths = per_mm;
  }
  found.thousandths = in.thousandths;
  input = positions(std::move(input), in, found.thousandths);
  output = positions(std::move(output), out, found.thousandths);
  found.mapping = {mapped_column(file, found.columns.input, in, found.is_rotary),
                   mapped_column(file, found.columns.output, out, found.is_rotary)};
}

}  // namespace

std::size_t recorded_axis(RecordedMachine const& machine, std::optional<std::string> const& name,
                          RecordingFile const& file) {
  auto const axes = chosen_axes(machine.image, name);
  if (axes.size() == 1) return axes.front();
  if (machine.machine != nullptr) {
    using recordings::Object;
    auto const shown =
        recorded_axes(file, *machine.machine, {Object::position_unfiltered, Object::position_filtered});
    if (shown.size() == 1) return shown.front();
  }
  throw Failure({says::name_an_axis, {{"file", machine.path}, {"count", std::to_string(axes.size())}}});
}

RecordedAxis compare_axis(RecordedMachine const& machine, std::size_t axis, RecordingFile const& file,
                          WantedColumns const& columns, PositionUnits const& units,
                          std::vector<comparison::KernelSwitch> switches) {
  auto const& image = machine.image;
  auto chain = configured(image, axis);
  chain.switches = std::move(switches);
  RecordedAxis found{
      .columns = read_recorded_columns(file, place_of(machine, axis), columns, image.cycle_time),
      .mapping = {},
      .readings = comparison::readings(chain),
      .result = {},
      .is_guard = image.axes[axis].slot && image.axes[axis].slot->family == machine::KernelFamily::guard,
      .is_rotary = image.axes[axis].type != translatory};
  read_positions(found, file, units, image.axes[axis]);
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
