#include "validator/rules/helpers.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/views/units_text.hpp"

namespace axisc::validator {

bool is_blank(SourceText const& text) {
  return text.bytes().find_first_not_of(" \t\r\n", text.text_begin()) == std::string_view::npos;
}

void name_parameter(Finding& finding, schema::Parameter const& row, schema::Slot slot) {
  finding.parameter = schema::slot_name(row, slot);
  finding.p_axis = schema::number_text(row.kind, row.p_axis);
}

void name_parameter(Finding& finding, Line const& line) {
  LineValue const line_value = line.context.list.line_values[line.number];
  if (line_value.known()) return name_parameter(finding, *line_value.row, line_value.slot);
  finding.parameter = line.name();
  if (line_value.row_known()) {
    finding.p_axis = schema::number_text(line_value.row->kind, line_value.row->p_axis);
  }
}

void set_reaction(Finding& finding, SentenceRef text, std::vector<Argument> arguments, std::string value) {
  if (!finding.control) finding.control.emplace();
  finding.control->reaction = message(text, std::move(arguments));
  finding.control->value = std::move(value);
}

void add_physical(Finding& finding, schema::Parameter const& row, machine::AxisType type, double value) {
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

Wording range_text(schema::Parameter const& parameter, std::string_view unit, bool physical_units) {
  auto const number = [&](schema::Limit const& limit) {
    return physical_units ? physical(limit.number, unit) : exact_number(limit.number);
  };
  schema::Limit const& minimum = parameter.minimum;
  schema::Limit const& maximum = parameter.maximum;
  std::string const name(parameter.name.substr(parameter.name.find_last_of('.') + 1));
  bool const below = minimum.kind == schema::Limit::Kind::number;
  bool const above = maximum.kind == schema::Limit::Kind::number;
  if (!above) return name + (minimum.open ? " > " : " ≥ ") + number(minimum);
  Wording const upper = name + (maximum.open ? " < " : " ≤ ") + number(maximum);
  return below ? number(minimum) + (minimum.open ? " < " : " ≤ ") + upper : upper;
}

bool is_default_or_off(schema::Parameter const& parameter, double value) {
  std::optional<schema::Value> const standard = schema::default_value(parameter);
  return standard && standard->number == value;
}

Wording allowed_values(schema::Parameter const& parameter) {
  bool const has_words = !parameter.symbols.empty();
  Wording text;
  for (schema::Symbol const& symbol : has_words ? parameter.symbols : parameter.number_names) {
    if (!text.empty()) text += ", ";
    text += has_words ? Wording(symbol.word) : number_name(parameter, symbol);
    if (symbol.number) text += " (" + std::to_string(*symbol.number) + ")";
  }
  return text;
}

}  // namespace axisc::validator
