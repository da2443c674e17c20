#include "axisc/answers/difference/parameter_difference.hpp"

#include "diagnostics/format_number.hpp"
#include "schema/descriptions/description.hpp"
#include "schema/value.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace axisc {

namespace {

using validator::EffectiveValue;

std::string without_blanks(std::string_view text) {
  std::string kept;
  std::copy_if(text.begin(), text.end(), std::back_inserter(kept),
               [](char character) { return character != ' ' && character != '\t'; });
  return kept;
}

std::optional<int> number_of_symbol(schema::Parameter const& row, std::string_view word) {
  auto const* const symbol = schema::read_symbol(row, word).symbol;
  return symbol != nullptr ? symbol->number : std::nullopt;
}

bool same_value(schema::Parameter const& row, schema::Value const& a, schema::Value const& b) {
  if (schema::is_bit_mask(row)) {
    return without_blanks(a.text) == without_blanks(b.text) && (!a.text.empty() || a.number == b.number);
  }
  if (row.is_enumeration()) {
    if (a.text == b.text) return true;
    auto const number = number_of_symbol(row, a.text);
    return number && number == number_of_symbol(row, b.text);
  }
  return row.type == schema::DataType::string ? a.text == b.text : a.number == b.number;
}

/// Where one of them is not a value of its parameter: two ways to write a number, or the same text.
bool same_text(std::string const& a, std::string const& b) {
  auto const number_a = schema::read_real(a);
  auto const number_b = schema::read_real(b);
  if (number_a.status != schema::NumberStatus::good || number_b.status != schema::NumberStatus::good) {
    return a == b;
  }
  return number_a.number == number_b.number;
}

class ParametersOfSide {
 public:
  ParametersOfSide(ComparedMachine const& machine, ComparedAxis const& axis)
      : machine_(machine), axis_(axis) {}

  [[nodiscard]] std::vector<EffectiveValue const*> set_values() const { return axis_.values->set_values(); }

  /// The effective value of a parameter, which a schema file of the other side may have brought; null for
  /// such a one.
  [[nodiscard]] EffectiveValue const* find(std::string const& name) const {
    auto const found = axis_.values->catalogue().find_exact(name);
    return found ? &(*axis_.values)[found.slot] : nullptr;
  }

  [[nodiscard]] ComparedValue compared(EffectiveValue const& value) const {
    ComparedValue result;
    result.value = value.value;
    if (value.set()) {
      result.state = ValueState::set;
      result.text = machine_.written(value);
      result.place = machine_.place_of(axis_, value);
    } else if (value.row->has_default) {
      result.state = ValueState::standard;
      result.text = value.row->default_text;
    }
    if (value.referenced) result.resolved = format_exact(value.value.number);
    return result;
  }

 private:
  ComparedMachine const& machine_;
  ComparedAxis const& axis_;
};

/// A value that the control can use.
bool is_known(EffectiveValue const& value) {
  if (value.set()) return !value.unusable;
  return value.referenced || schema::default_value(*value.row).has_value();
}

/// What nearly all parameters of two versions of a list are.
bool are_set_alike(EffectiveValue const& was, EffectiveValue const& is) {
  return was.set() && is.set() && is_known(was) && is_known(is) && same_value(*is.row, was.value, is.value);
}

bool means_the_same(ComparedValue const& was, EffectiveValue const& old_value, ComparedValue const& is,
                    EffectiveValue const& new_value) {
  if (was.state == ValueState::missing || is.state == ValueState::missing) return was.state == is.state;
  if (is_known(old_value) && is_known(new_value)) return same_value(*new_value.row, was.value, is.value);
  return same_text(was.text, is.text);
}

}  // namespace

bool is_own(schema::Parameter const& row) {
  return std::find(std::begin(own_parameters), std::end(own_parameters), row.name) !=
         std::end(own_parameters);
}

std::vector<ParameterChange> compare_parameters(ComparedMachine const& before, ComparedAxis const& old_axis,
                                                ComparedMachine const& after, ComparedAxis const& new_axis) {
  if (old_axis.values == nullptr || new_axis.values == nullptr) return {};
  ParametersOfSide const old_side(before, old_axis);
  ParametersOfSide const new_side(after, new_axis);
  std::map<std::string, std::pair<EffectiveValue const*, EffectiveValue const*>> values;
  for (auto const* const value : old_side.set_values()) values[parameter_name(*value)].first = value;
  for (auto const* const value : new_side.set_values()) values[parameter_name(*value)].second = value;
  std::vector<ParameterChange> changes;
  for (auto const& [name, pair] : values) {
    auto const* const was = pair.first != nullptr ? pair.first : old_side.find(name);
    auto const* const is = pair.second != nullptr ? pair.second : new_side.find(name);
    auto const* const listed = is != nullptr ? is : was;
    if (listed == nullptr) continue;
    if (was != nullptr && is != nullptr && are_set_alike(*was, *is)) continue;
    ParameterChange change{.name = name,
                           .row = listed->row,
                           .unit = {},
                           .before = was != nullptr ? old_side.compared(*was) : ComparedValue{},
                           .after = is != nullptr ? new_side.compared(*is) : ComparedValue{}};
    change.equal = was != nullptr && is != nullptr && means_the_same(change.before, *was, change.after, *is);
    if (change.equal && change.before.state == change.after.state) continue;
    change.unit = new_axis.type == machine::AxisType::translatory ? change.row->unit_translatory
                                                                  : change.row->unit_rotary;
    change.restart = schema::description_of(*change.row).restart;
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace axisc
