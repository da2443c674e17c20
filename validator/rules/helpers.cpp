#include "validator/rules/helpers.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/units_text.hpp"

namespace axisc::validator {

std::string written_name(ListContext const& context, grammar::Assignment const& assignment) {
  return context.source.utf8(assignment.name);
}

std::string p_axis_of(Reading const& reading) {
  return reading.row_known() ? schema::p_axis_text(reading.row->p_axis) : std::string{};
}

Finding& add_at(ListContext const& context, Report& report, grammar::Assignment const& assignment,
                Reading const& reading, Span span, Message text) {
  Place const place = place_of(context, span);
  if (reading.known()) return report.add(place, *reading.row, reading.slot, std::move(text));
  Finding& finding = report.add(place, std::move(text));
  finding.parameter = written_name(context, assignment);
  finding.p_axis = p_axis_of(reading);
  return finding;
}

void set_reaction(Finding& finding, Text text, std::vector<Argument> arguments, std::string value) {
  if (!finding.control) finding.control.emplace();
  finding.control->reaction = message(text, std::move(arguments));
  finding.control->value = std::move(value);
}

void add_physical(Finding& finding, schema::Parameter const& row, AxisType type, double value) {
  std::string_view const unit = unit_of(row, type);
  if (finding.control && !unit.empty()) finding.control->physical = physical(value, unit);
}

Fix replace_by(Place place, std::string text, Message title, FixSafety safety) {
  Fix fix;
  fix.title = std::move(title);
  fix.edits.push_back({.place = place, .text = std::move(text)});
  fix.safety = safety;
  return fix;
}

std::string range_text(schema::Parameter const& parameter, std::string_view unit, bool physical_units) {
  auto const number = [&](schema::Limit const& limit) {
    return physical_units ? physical(limit.number, unit) : format_exact(limit.number);
  };
  schema::Limit const& minimum = parameter.minimum;
  schema::Limit const& maximum = parameter.maximum;
  std::string const name(parameter.name.substr(parameter.name.find_last_of('.') + 1));
  bool const below = minimum.kind == schema::Limit::Kind::number;
  bool const above = maximum.kind == schema::Limit::Kind::number;
  if (!above) return name + (minimum.open ? " > " : " ≥ ") + number(minimum);
  std::string const upper = name + (maximum.open ? " < " : " ≤ ") + number(maximum);
  return below ? number(minimum) + (minimum.open ? " < " : " ≤ ") + upper : upper;
}

bool is_default_or_off(schema::Parameter const& parameter, double value) {
  std::optional<Value> const standard = default_value(parameter);
  return standard && standard->number == value;
}

}  // namespace axisc::validator
