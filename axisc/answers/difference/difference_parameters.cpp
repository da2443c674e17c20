#include "axisc/answers/difference/difference_parts.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"
#include "schema/data_type.hpp"
#include "schema/descriptions/description.hpp"
#include "validator/views/units_text.hpp"

namespace axisc::says {

constexpr Sentence not_set{"not set", "nicht gesetzt"};
constexpr Sentence with_default{"{value} (default)", "{value} (Standardwert)"};
constexpr Sentence resolved{"{value} = {number}", "{value} = {number}"};
constexpr Sentence with_meaning{"{value} [{meaning}]", "{value} [{meaning}]"};
constexpr Sentence change{"{before} → {after}", "{before} → {after}"};
constexpr Sentence with_unit{"{value} {unit}", "{value} {unit}"};
constexpr Sentence numbered{"{number}: {meaning}", "{number}: {meaning}"};
constexpr Sentence needs_restart{"{meaning}; takes effect after a restart of the control",
                                 "{meaning}; wirkt erst nach einem Neustart der Steuerung"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// In plain numbers; of a switch as lists write it.
std::string default_of(schema::Parameter const& row, ComparedValue const& value) {
  return row.type == schema::DataType::boolean ? format_exact(value.value.number)
                                               : validator::default_text(row);
}

/// What a number or symbol of the parameter stands for; empty where the catalogue does not tell.
Wording meaning_of(schema::Parameter const& row, ComparedValue const& value) {
  if (row.type == schema::DataType::boolean || !value.resolved.empty()) return {};
  auto const number = format_exact(value.value.number);
  bool const has_number = row.type != schema::DataType::string;
  for (auto const& described : schema::description_of(row).values) {
    bool const is_meant = has_number ? described.value == number : described.value == value.value.text;
    if (is_meant) return Wording(described.meaning);
  }
  for (auto const& named : row.number_names) {
    if (has_number && named.number == value.value.number) return named.word;
  }
  bool const is_plain_number = !value.text.empty() && value.text.front() >= '0' && value.text.front() <= '9';
  return row.is_enumeration() && is_plain_number ? value.value.text : std::string();
}

/// Of the second value alone: both have the same.
enum class UnitOf : std::uint8_t { left_out, shown };

Value value_of(ParameterChange const& change, ComparedValue const& value, UnitOf unit) {
  if (value.state == ValueState::missing) return Words(says::not_set);
  auto const text = value.state == ValueState::standard ? default_of(*change.row, value) : value.text;
  Value told = text.empty() ? "\"\"" : text;
  if (!value.resolved.empty()) told = Words(says::resolved, {{"value", told}, {"number", value.resolved}});
  if (auto const meaning = meaning_of(*change.row, value); !meaning.empty()) {
    told = Words(says::with_meaning, {{"value", told}, {"meaning", meaning}});
  }
  if (unit == UnitOf::shown && !change.unit.empty()) {
    told = Words(says::with_unit, {{"value", told}, {"unit", validator::unit_name(change.unit)}});
  }
  return value.state == ValueState::standard ? Words(says::with_default, {{"value", told}}) : told;
}

Value meaning_of(ParameterChange const& change, bool tells_restart) {
  Value told = Wording(schema::description_of(*change.row).what);
  auto const number = schema::p_axis_text(change.row->p_axis);
  if (!number.empty()) {
    told = told.is_blank() ? Value(number)
                           : Words(says::numbered, {{"number", number}, {"meaning", std::move(told)}});
  }
  return tells_restart && change.restart ? Words(says::needs_restart, {{"meaning", told}}) : told;
}

/// By ValueState.
constexpr std::string_view states[] = {"set", "default", "missing"};

std::string_view word_of(ValueState state) {
  return states[static_cast<std::size_t>(state)];
}

Value written(ComparedValue const& value) {
  return value.state == ValueState::set ? Value(value.text) : Value();
}

Row data_row(ParameterChange const& change) {
  auto const& row = *change.row;
  return {change.name,
          written(change.before),
          written(change.after),
          row.has_default ? Value(validator::default_text(row)) : Value(),
          change.before.place,
          change.after.place,
          word_of(change.before.state),
          word_of(change.after.state),
          change.equal,
          schema::p_axis_text(row.p_axis),
          Wording(schema::description_of(row).what),
          change.unit,
          change.restart};
}

}  // namespace

Table parameter_table(ShownDifference const& shown) {
  // Both values in one column: a table that is too wide for a terminal is divided between columns.
  auto const [before, after] = sides_of(shown);
  return {.key = {},
          .columns = {head_column({}, labels::parameter),
                      column({}, Words(says::change, {{"before", before}, {"after", after}})),
                      column({}, labels::meaning)},
          .rows = {},
          .audience = Audience::people};
}

Row parameter_row(ShownDifference const& shown, ParameterChange const& change) {
  return {change.name,
          Words(says::change, {{"before", value_of(change, change.before, UnitOf::left_out)},
                               {"after", value_of(change, change.after, UnitOf::shown)}}),
          meaning_of(change, !shown.difference.of_one_machine)};
}

Table parameter_data(AxisDifference const& axis) {
  return table_of(
      "parameters",
      data_columns({"name", "before", "after", "default", "place_before", "place_after", "state_before",
                    "state_after", "equal", "p_axis", "meaning", "unit", "restart"}),
      axis.parameters, data_row);
}

}  // namespace axisc
