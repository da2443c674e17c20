#include "validator/effective_values.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <tuple>
#include <utility>

namespace axisc::validator {
namespace {

std::vector<EffectiveValue> internal_defaults(schema::Catalogue const& catalogue) {
  std::vector<EffectiveValue> defaults(catalogue.slot_count());
  for (std::size_t i = 0; i < defaults.size(); ++i) {
    auto const slot = static_cast<schema::Slot>(i);
    schema::Parameter const& parameter = catalogue.parameter_of(slot);
    defaults[i].slot = slot;
    defaults[i].row = &parameter;
    defaults[i].value = default_value(parameter).value_or(Value{});
  }
  return defaults;
}

/// Looks for the name with its indices.
template <typename Find>
schema::NameLookup find_pattern(std::string_view pattern, std::uint32_t first_index,
                                std::uint32_t second_index, Find find) {
  std::string name;
  name.reserve(pattern.size() + 4);
  std::uint32_t index = first_index;
  for (char const c : pattern) {
    if (c == ']') {
      name += std::to_string(index);
      index = second_index;
    }
    name += c;
  }
  schema::NameLookup const lookup = find(name);
  assert(lookup.status == schema::NameLookup::Status::found);
  return lookup;
}

}  // namespace

bool configured(EffectiveValue const& value) {
  if (!value.set() || value.unusable) return false;
  auto const standard = default_value(*value.row);
  if (!standard || standard->number != value.value.number) return true;
  // Some words have no number.
  return !standard->text.empty() && !value.value.text.empty() && standard->text != value.value.text;
}

std::string parameter_name(EffectiveValue const& value) {
  return schema::slot_name(*value.row, value.slot);
}

std::string parameter_number(EffectiveValue const& value) {
  return schema::p_axis_text(value.row->p_axis);
}

EffectiveValues::EffectiveValues(schema::Catalogue catalogue)
    : catalogue_(std::move(catalogue)), entry_of_slot_(catalogue_.slot_count(), 0) {
  if (!catalogue_.is_built_in()) own_defaults_ = internal_defaults(catalogue_);
}

EffectiveValue const& EffectiveValues::internal_default(schema::Slot slot) const {
  static std::vector<EffectiveValue> const built_in = internal_defaults({});
  return (own_defaults_.empty() ? built_in : own_defaults_)[static_cast<std::size_t>(slot)];
}

EffectiveValue const& EffectiveValues::operator[](schema::Slot slot) const {
  std::uint32_t const entry = entry_of_slot_[static_cast<std::size_t>(slot)];
  return entry == 0 ? internal_default(slot) : entries_[entry - 1];
}

EffectiveValue const& EffectiveValues::at(std::string_view pattern, std::uint32_t first_index,
                                          std::uint32_t second_index) const {
  return (*this)[find_pattern(pattern, first_index, second_index, [this](std::string_view name) {
                   return catalogue_.find(name);
                 }).slot];
}

EffectiveValue& EffectiveValues::edit(schema::Slot slot) {
  bool const is_new = entry_of_slot_[static_cast<std::size_t>(slot)] == 0;
  EffectiveValue& entry = replace(slot);
  if (is_new) entry.value = internal_default(slot).value;
  return entry;
}

EffectiveValue& EffectiveValues::replace(schema::Slot slot) {
  std::uint32_t& entry = entry_of_slot_[static_cast<std::size_t>(slot)];
  if (entry == 0) {
    EffectiveValue& added = entries_.emplace_back();
    added.slot = slot;
    added.row = &catalogue_.parameter_of(slot);
    entry = static_cast<std::uint32_t>(entries_.size());
    set_slots_.push_back(slot);
  }
  return entries_[entry - 1];
}

void EffectiveValues::expect(std::size_t count) {
  std::size_t const most = entries_.size() + std::min(count, catalogue_.slot_count());
  entries_.reserve(most);
  set_slots_.reserve(most);
}

void EffectiveValues::order_set_slots() {
  auto const before = [this](schema::Slot left, schema::Slot right) {
    EffectiveValue const& a = (*this)[left];
    EffectiveValue const& b = (*this)[right];
    return std::tie(a.origin, a.line, a.slot) < std::tie(b.origin, b.line, b.slot);
  };
  // One list without repetitions leaves nothing to do.
  if (std::is_sorted(set_slots_.begin(), set_slots_.end(), before)) return;
  std::sort(set_slots_.begin(), set_slots_.end(), before);
}

schema::Slot slot_at(std::string_view pattern, std::uint32_t first_index, std::uint32_t second_index) {
  return find_pattern(pattern, first_index, second_index, schema::find).slot;
}

}  // namespace axisc::validator
