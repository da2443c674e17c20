#include "axisc/files/recorded_positions.hpp"

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
    "vor "
    "den Filtern mit --in ACHSE=SPALTE nennen, einmal je aufgezeichnete Achse"};
constexpr Sentence foreign_axis{"--in {axis}={column}: the channel has the axes {axes}",
                                "--in {axis}={column}: der Kanal hat die Achsen {axes}"};

}  // namespace axisc::says

namespace axisc {

RecordedPositions read_recorded_positions(std::string const& file, recordings::ByteSource source,
                                          std::vector<std::string> const& axes,
                                          std::vector<AxisColumn> const& named,
                                          design::CycleTime cycle_time) {
  for (auto const& each : named) {
    if (std::find(axes.begin(), axes.end(), each.axis) != axes.end()) continue;
    throw Failure(
        {says::foreign_axis, {{"axis", each.axis}, {"column", each.column}, {"axes", joined(axes)}}});
  }
  RecordedPositions found;
  auto const choose = [&](ColumnNames const& columns) {
    std::vector<std::size_t> chosen;
    auto const values = columns.values();
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      auto const by_option = std::find_if(named.begin(), named.end(),
                                          [&](AxisColumn const& each) { return each.axis == axes[axis]; });
      auto const by_name = std::find_if(values.begin(), values.end(), [&](std::size_t column) {
        return ascii::equal_ignoring_case(columns.names[column], axes[axis]);
      });
      bool const is_only = axes.size() == 1 && values.size() == 1;
      if (by_option == named.end() && by_name == values.end() && !is_only) continue;
      found.axes.push_back(axis);
      if (by_option != named.end()) {
        chosen.push_back(columns.index_of(by_option->column));
      } else {
        chosen.push_back(is_only ? values.front() : *by_name);
      }
    }
    if (chosen.empty()) {
      throw Failure(
          {says::no_axis_column, {{"file", file}, {"axes", joined(axes)}, {"known", columns.known()}}},
          csv_malformed);
    }
    return chosen;
  };
  found.recorded = read_recorded_signals(file, std::move(source), choose, cycle_time);
  return found;
}

}  // namespace axisc
