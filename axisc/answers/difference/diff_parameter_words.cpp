#include "axisc/answers/difference/diff_words.hpp"
#include "diagnostics/format_number.hpp"
#include "schema/data_type.hpp"
#include "schema/descriptions/description.hpp"
#include "validator/views/units_text.hpp"

namespace axisc::says {

constexpr Sentence not_set{"not set", "nicht gesetzt"};
constexpr Sentence diff_default{"{value} (default)", "{value} (Standardwert)"};
constexpr Sentence old_place{"old: {place}", "alt: {place}"};
constexpr Sentence new_place{"new: {place}", "neu: {place}"};
constexpr Sentence needs_restart{"takes effect after a restart of the control",
                                 "wirkt erst nach einem Neustart der Steuerung"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// In plain numbers; of a switch as lists write it.
std::string default_of(schema::Parameter const& row, ComparedValue const& value) {
  return row.type == schema::DataType::boolean ? format_exact(value.value.number)
                                               : validator::default_text(row);
}

/// What a number or symbol of the parameter stands for; empty where the catalogue does not tell.
std::string meaning_of_value(ParameterChange const& change, ComparedValue const& value, Language language) {
  auto const& row = *change.row;
  if (row.type == schema::DataType::boolean || !value.resolved.empty()) return {};
  auto const number = format_exact(value.value.number);
  bool const has_number = row.type != schema::DataType::string;
  for (auto const& described : schema::description_of(row).values) {
    bool const is_meant = has_number ? described.value == number : described.value == value.value.text;
    if (is_meant) return std::string(described.meaning.in(language));
  }
  for (auto const& named : row.number_names) {
    if (has_number && named.number == value.value.number) return std::string(named.word);
  }
  bool const is_plain_number = !value.text.empty() && value.text.front() >= '0' && value.text.front() <= '9';
  return row.is_enumeration() && is_plain_number ? std::string(value.value.text) : std::string();
}

}  // namespace

DiffParameter DiffWords::parameter(ParameterChange const& change) const {
  DiffLine line{change.name, value(change, change.before), value(change, change.after)};
  if (!change.unit.empty()) line.after += " " + validator::unit_name(change.unit).in(language_);
  return {.line = std::move(line),
          .meaning = meaning(change),
          .restart =
              change.restart && !shown_.difference.of_one_machine ? say(says::needs_restart) : std::string(),
          .places = {places(change)}};
}

std::string DiffWords::value(ParameterChange const& change, ComparedValue const& value) const {
  if (value.state == ValueState::missing) return say(says::not_set);
  auto text = value.state == ValueState::standard ? default_of(*change.row, value) : value.text;
  if (text.empty()) text = "\"\"";
  if (!value.resolved.empty()) text += " = " + value.resolved;
  if (auto const meant = meaning_of_value(change, value, language_); !meant.empty()) {
    text += " [" + meant + "]";
  }
  return value.state == ValueState::standard ? say(says::diff_default, {{"value", text}}) : text;
}

std::string DiffWords::meaning(ParameterChange const& change) const {
  auto text = std::string(schema::description_of(*change.row).what.in(language_));
  auto const number = schema::p_axis_text(change.row->p_axis);
  if (!number.empty()) text = text.empty() ? number : number + ": " + text;
  return text;
}

std::vector<std::string> DiffWords::places(ParameterChange const& change) const {
  auto const& before = change.before.place;
  auto const& after = change.after.place;
  if (shown_.difference.of_one_machine) {
    std::vector<std::string> places;
    if (!before.empty()) places.push_back(shown_.before + ": " + before);
    if (!after.empty()) places.push_back(shown_.after + ": " + after);
    return places;
  }
  if (before.empty()) return {say(says::new_place, {{"place", after}})};
  if (after.empty()) return {say(says::old_place, {{"place", before}})};
  return {before, after};
}

}  // namespace axisc
