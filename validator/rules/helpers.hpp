// Helpers for the checks of AX1 and AX2.
#pragma once

#include "validator/engine/rule.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::validator {

[[nodiscard]] inline Message message(SentenceRef text, std::vector<Argument> arguments = {}) {
  return {text, std::move(arguments)};
}

/// A message from arguments that are moved, for checks that many lines of one list may fail.
template <typename... Arguments>
[[nodiscard]] Message message_of(SentenceRef text, Arguments... arguments) {
  Message result{text};
  result.arguments.reserve(sizeof...(arguments));
  (result.arguments.push_back(std::move(arguments)), ...);
  return result;
}

[[nodiscard]] inline Place place_of(ListContext const& context, Span span) {
  return {.source = context.list.source, .span = span};
}

/// Where a list begins, for what no line of it says.
[[nodiscard]] inline Place beginning_of(SourceId source, SourceText const& text) {
  return {.source = source, .span = {.begin = text.text_begin(), .end = text.text_begin()}};
}

/// A list in which nothing is written, not even a comment.
[[nodiscard]] bool is_blank(SourceText const& text);

/// One assignment of a list, for checks of single lines and for the text of their findings.
struct Line {
  ListContext const& context;
  std::uint32_t number;

  [[nodiscard]] grammar::Assignment const& assignment() const {
    return context.list.tree.assignments[number];
  }
  /// The complete line value of a doubtful line; context.list.line_values has those of all lines.
  [[nodiscard]] LineValue const& line_value() const { return context.list.line_values.closer(number); }
  [[nodiscard]] Place place(Span span) const { return place_of(context, span); }
  /// The name as written in the list.
  [[nodiscard]] std::string name() const { return context.source.utf8(assignment().name); }
  [[nodiscard]] std::string text(Span span) const { return context.source.utf8(span); }
};

/// Sets what every finding about a line states about its parameter.
void name_parameter(Finding& finding, Line const& line);
void name_parameter(Finding& finding, schema::Parameter const& row, schema::Slot slot);

/// A finding at `span` of a line, about its parameter if that is known; `describe(finding, line)` makes its
/// text.
template <auto describe>
Reported& report_line(Report& report, Line const& line, Span span) {
  return report.later(line.place(span), [line](Finding& finding) {
    name_parameter(finding, line);
    describe(finding, line);
  });
}

void set_reaction(Finding& finding, SentenceRef text, std::vector<Argument> arguments = {},
                  std::string value = {});
/// Adds the control's value, the raw number `value`, in its usual unit.
void add_physical(Finding& finding, schema::Parameter const& row, machine::AxisType type, double value);

/// A fix of one edit.
[[nodiscard]] Fix replace_by(Place place, std::string text, Message title,
                             FixSafety safety = FixSafety::changes_behaviour);

/// The lists of an axis, default list first; the default list may be null.
[[nodiscard]] inline std::array<LoadedList const*, 2> lists_of(AxisContext const& context) {
  return {context.default_list, &context.axis_list};
}

/// Calls `visit(line)` for the assignments that may be wrong on their own.
template <typename Visit>
void for_each_doubtful(ListContext const& context, Visit visit) {
  for (std::uint32_t const number : context.list.line_values.doubtful()) visit(Line{context, number});
}

/// One assignment of a list as an axis sees it, for checks that depend on the axis type.
struct AxisLine {
  AxisContext const& context;
  std::uint32_t number;
  bool in_default_list;

  [[nodiscard]] LoadedList const& list() const {
    return in_default_list ? *context.default_list : context.axis_list;
  }
  [[nodiscard]] grammar::Assignment const& assignment() const { return list().tree.assignments[number]; }
  /// The complete line value of a doubtful line.
  [[nodiscard]] LineValue const& line_value() const { return list().line_values.closer(number); }
  [[nodiscard]] Place place() const { return {.source = list().source, .span = assignment().value}; }
};

/// for_each_doubtful() over the lists of an axis.
template <typename Visit>
void for_each_doubtful(AxisContext const& context, Visit visit) {
  for (bool const in_default_list : {true, false}) {
    if (in_default_list && context.default_list == nullptr) continue;
    AxisLine line{context, 0, in_default_list};
    for (std::uint32_t const number : line.list().line_values.doubtful()) {
      line.number = number;
      visit(line);
    }
  }
}

/// "LOWPASS (1), HIGHPASS (2)": its words, or, where it has none, the meanings of its numbers.
[[nodiscard]] Wording allowed_values(schema::Parameter const& parameter);

/// "1 ≤ guete ≤ 10", with one limit "fcut ≥ 1 Hz": the name is the last part of the parameter's.
[[nodiscard]] Wording range_text(schema::Parameter const& parameter, std::string_view unit,
                                 bool physical_units);

/// Real lists write "off" as the default value, or as 0 where that is the default.
[[nodiscard]] bool is_default_or_off(schema::Parameter const& parameter, double value);

}  // namespace axisc::validator
