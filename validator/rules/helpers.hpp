// What the checks of AX1 and AX2 share.
#pragma once

#include "validator/rule.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::validator {

[[nodiscard]] inline Message message(Text text, std::vector<Argument> arguments = {}) {
  return {.text = text, .arguments = std::move(arguments)};
}

/// The same of values that are moved, for checks that many lines of one list may fail.
template <typename... Arguments>
[[nodiscard]] Message message_of(Text text, Arguments... arguments) {
  Message result{.text = text, .arguments = {}};
  result.arguments.reserve(sizeof...(arguments));
  (result.arguments.push_back(std::move(arguments)), ...);
  return result;
}

[[nodiscard]] inline Place place_of(ListContext const& context, Span span) {
  return {.source = context.list.source, .span = span};
}

/// The name as the list writes it.
[[nodiscard]] std::string written_name(ListContext const& context, grammar::Assignment const& assignment);

/// A finding at `span` of the line of `assignment`, about its parameter where that is known.
Finding& add_at(ListContext const& context, Report& report, grammar::Assignment const& assignment,
                Reading const& reading, Span span, Message text);

/// "P-AXIS-00140" of the row, empty where nothing is known.
[[nodiscard]] std::string p_axis_of(Reading const& reading);

void set_reaction(Finding& finding, Text text, std::vector<Argument> arguments = {}, std::string value = {});
/// Says beside the control's value, which is the raw number `value`, what that is for a person.
void add_physical(Finding& finding, schema::Parameter const& row, AxisType type, double value);

/// A fix of one edit.
[[nodiscard]] Fix replace_by(Place place, std::string text, Message title,
                             FixSafety safety = FixSafety::changes_behaviour);

/// The lists of an axis in the order in which they count; the first may be null.
[[nodiscard]] inline std::array<LoadedList const*, 2> lists_of(AxisContext const& context) {
  return {context.default_list, &context.axis_list};
}

/// Calls `visit(assignment, reading)` for every assignment of a list.
template <typename Visit>
void for_each_reading(LoadedList const& list, Visit visit) {
  for (std::size_t i = 0; i < list.readings.size(); ++i) visit(list.tree.assignments[i], list.readings[i]);
}

/// The same for those that alone may be wrong, for checks of single lines.
template <typename Visit>
void for_each_doubtful(LoadedList const& list, Visit visit) {
  for (std::uint32_t const i : list.readings.doubtful()) visit(list.tree.assignments[i], list.readings[i]);
}

/// "1 ≤ guete ≤ 10", with one limit "fcut ≥ 1 Hz": the name is the last part of the parameter's.
[[nodiscard]] std::string range_text(schema::Parameter const& parameter, std::string_view unit,
                                     bool physical_units);

/// Real lists write "off" as the default value, or as 0 where that is the default.
[[nodiscard]] bool is_default_or_off(schema::Parameter const& parameter, double value);

}  // namespace axisc::validator
