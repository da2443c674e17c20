#include "axisc/files/recorded_positions.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/joined.hpp"

#include <algorithm>
#include <utility>

namespace axisc::says {

constexpr Sentence no_axis_column{
    "{file} has no column for an axis of the channel ({axes}); it has {known}; name the command position "
    "before the filters with --in AXIS=COLUMN, once for each recorded axis",
    "{file} hat keine Spalte für eine Achse des Kanals ({axes}); vorhanden sind {known}; die Sollposition "
    "vor den Filtern mit --in ACHSE=SPALTE nennen, einmal je aufgezeichnete Achse"};
constexpr Sentence foreign_axis{"--in {axis}={column}: the channel has the axes {axes}",
                                "--in {axis}={column}: der Kanal hat die Achsen {axes}"};
constexpr Sentence column_of_axis{
    "{option} {text}: name the column of an axis, {option} X=COLUMN, once for each",
    "{option} {text}: die Spalte einer Achse nennen, {option} X=SPALTE, einmal je Achse"};

}  // namespace axisc::says

namespace axisc {

std::vector<AxisColumn> axis_columns(std::string const& option, std::vector<std::string> const& texts) {
  std::vector<AxisColumn> columns;
  for (auto const& text : texts) {
    auto const assigned = parse_assigned(text);
    if (!assigned) throw Failure({says::column_of_axis, {{"option", option}, {"text", text}}});
    columns.push_back({.axis = assigned->name, .column = assigned->value});
  }
  return columns;
}

std::optional<ChosenColumn> column_called(RecordingFile const& file, std::string_view name) {
  auto const& channels = file.recording.channels;
  auto const found = std::find_if(channels.begin(), channels.end(), [&](recordings::Channel const& channel) {
    return ascii::equal_ignoring_case(recordings::plain_name(channel.name), name);
  });
  if (found == channels.end()) return std::nullopt;
  auto const channel = static_cast<std::size_t>(found - channels.begin());
  return ChosenColumn{.channel = channel, .by = FoundBy::name, .object = recordings::object_of(*found)};
}

RecordedPositions read_recorded_positions(RecordingFile const& file, machine::Machine const& machine,
                                          std::size_t group, bool in_machine,
                                          std::vector<AxisColumn> const& named) {
  std::vector<std::string> axes;
  for (auto const axis : machine.groups[group].axes) axes.push_back(machine.axes[axis].name);
  for (auto const& each : named) {
    if (std::find(axes.begin(), axes.end(), each.axis) != axes.end()) continue;
    throw Failure(
        {says::foreign_axis, {{"axis", each.axis}, {"column", each.column}, {"axes", joined(axes)}}});
  }
  RecordedPositions found;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    auto const by_option = std::find_if(named.begin(), named.end(),
                                        [&](AxisColumn const& each) { return each.axis == axes[i]; });
    auto const place = axis_place(machine, machine.groups[group].axes[i], in_machine);
    auto column = by_option != named.end() ? std::optional(named_column(file, by_option->column))
                                           : find_column(file, place, recordings::Object::position_unfiltered,
                                                         "--in " + axes[i] + "=");
    if (!column) column = column_called(file, axes[i]);
    bool const is_only = axes.size() == 1 && file.recording.channels.size() == 1 &&
                         file.recording.form == recordings::Form::columns;
    if (!column && is_only) column = ChosenColumn{.channel = 0, .by = FoundBy::order};
    if (!column) continue;
    found.axes.push_back(i);
    found.columns.push_back(*column);
  }
  if (found.axes.empty()) {
    throw Failure(
        {says::no_axis_column, {{"file", file.name}, {"axes", joined(axes)}, {"known", file.known()}}},
        csv_malformed);
  }
  std::vector<std::size_t> channels;
  for (auto const& column : found.columns) channels.push_back(column.channel);
  constexpr double microseconds = 1000;
  found.recorded = cycles_of(file, channels, machine.cycle_time.microseconds() / microseconds);
  return found;
}

}  // namespace axisc
