#include "validator/rules/filter_words.hpp"

#include "diagnostics/format_number.hpp"
#include "schema/catalogue.hpp"
#include "schema/value.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axisc::validator::says {

constexpr Sentence type_here{"the type is set here", "hier wird der Typ gesetzt"};
constexpr Sentence type_default{"no list sets `{parameter}`: the type is `{type}` by default",
                                "keine Liste setzt `{parameter}`: der Typ ist dann `{type}`"};
constexpr Sentence filter_default{"no list sets `{parameter}`: the default {value} applies",
                                  "keine Liste setzt `{parameter}`: es gilt der Standardwert {value}"};
constexpr Sentence time_in_cycles{"{time} ({milliseconds}) are {cycles} cycles of {cycle}",
                                  "{time} ({milliseconds}) sind {cycles} Zyklen zu {cycle}"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {

std::string filter_name(FilterView const& filter) {
  std::string const enable = parameter_name(filter.enable);
  return enable.substr(0, enable.rfind('.'));
}

std::string symbol_word(EffectiveValue const& value) {
  if (!value.value.text.empty()) return std::string(value.value.text);
  schema::Symbol const* const symbol = schema::symbol_of_number(*value.row, value.value.number);
  return symbol != nullptr ? std::string(symbol->word) : number(value.value.number).written();
}

Wording number(double value) {
  return format_rounded(value, 6);
}

Wording percent(double share) {
  double const value = share * 100;
  double const rounded = std::round(value * 10) / 10;
  return std::abs(value) < 0.1 ? format_rounded(value, 2) : format_rounded(rounded, 6);
}

Wording microseconds(double value) {
  return number(value) + " µs";
}

Wording milliseconds(double value) {
  return number(value / 1e3) + " ms";
}

Message time_in_cycles(double time, design::CycleTime cycle_time) {
  return {says::time_in_cycles,
          {{"time", microseconds(time)},
           {"milliseconds", milliseconds(time)},
           {"cycles", number(cycle_time.cycles({time}))},
           {"cycle", microseconds(cycle_time.microseconds())}}};
}

void react(Finding& finding, Message reaction, std::string value) {
  if (!finding.control) finding.control.emplace();
  finding.control->reaction = std::move(reaction);
  finding.control->value = std::move(value);
}

void react(Finding& finding, std::string_view control, Message reaction, std::string value) {
  react(finding, std::move(reaction), std::move(value));
  finding.control->message = control;
}

void note_default(Finding& finding, EffectiveValue const& value) {
  if (value.set()) return;
  Wording const standard = value.value.text.empty() ? number(value.value.number) : value.value.text;
  finding.notes.push_back(
      {says::filter_default, {{"parameter", parameter_name(value)}, {"value", standard}}});
}

void relate_set_type(Finding& finding, EffectiveValue const& type) {
  if (type.value_place()) finding.related.push_back({*type.value_place(), {says::type_here, {}}});
}

void relate_type(Finding& finding, FilterView const& filter) {
  if (filter.type.value_place()) return relate_set_type(finding, filter.type);
  finding.notes.push_back(
      {says::type_default,
       {{"parameter", parameter_name(filter.type)}, {"type", std::string(filter.type_word())}}});
}

std::string_view time_constant_message(FilterContext const& context) {
  if (context.filter.port == FilterPort::additional_interface) return position_controller_refuses_time;
  return context.axis.type == machine::AxisType::spindle ? spindle_refuses_time : path_refuses_time;
}

}  // namespace axisc::validator::checks
