#include "validator/values/effective_values.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <tuple>
#include <utility>

namespace axisc::validator {
namespace {

EffectiveValue make_default(schema::Catalogue const& catalogue, schema::Slot slot) {
  EffectiveValue value;
  value.slot = slot;
  value.row = &catalogue.parameter_of(slot);
  value.value = schema::default_value(*value.row).value_or(schema::Value{});
  return value;
}

/// `filter[].order` with its indices.
std::string concrete_name(std::string_view pattern, std::uint32_t first_index, std::uint32_t second_index) {
  std::string name;
  name.reserve(pattern.size() + 4);
  for (std::uint32_t const index : {first_index, second_index}) {
    std::size_t const bracket = pattern.find(']');
    if (bracket == std::string_view::npos) break;
    name += pattern.substr(0, bracket);
    (name += std::to_string(index)) += ']';
    pattern.remove_prefix(bracket + 1);
  }
  return name.append(pattern);
}

template <typename Find>
schema::ConcreteParameter find_pattern(std::string_view pattern, std::uint32_t first_index,
                                       std::uint32_t second_index, Find find) {
  bool const has_indices = pattern.find('[') != std::string_view::npos;
  schema::ConcreteParameter const found =
      has_indices ? find(concrete_name(pattern, first_index, second_index)) : find(pattern);
  assert(found);
  return found;
}

}  // namespace

bool configured(EffectiveValue const& value) {
  if (!value.set() || value.unusable) return false;
  auto const standard = schema::default_value(*value.row);
  if (!standard || standard->number != value.value.number) return true;
  // Some symbols have no number.
  return !standard->text.empty() && !value.value.text.empty() && standard->text != value.value.text;
}

std::string parameter_name(EffectiveValue const& value) {
  return schema::slot_name(*value.row, value.slot);
}

std::string parameter_number(EffectiveValue const& value) {
  return schema::p_axis_text(value.row->p_axis);
}

EffectiveValue value_of_line(LoadedList const& list, std::size_t assignment) {
  grammar::Assignment const& line = list.tree.assignments[assignment];
  LineValue const line_value = list.line_values[assignment];
  EffectiveValue value;
  value.row = line_value.row;
  value.value = line_value.value;
  value.name_span = line.name;
  value.value_span = line.value;
  value.source = list.source;
  value.line = line.line;
  value.slot = line_value.slot;
  value.origin = list.is_default_list ? Origin::default_list : Origin::axis_list;
  value.has_value = true;
  value.unusable = !line_value.usable();
  return value;
}

bool stands_before(EffectiveValue const& a, EffectiveValue const& b) {
  return std::tie(a.origin, a.line, a.slot) < std::tie(b.origin, b.line, b.slot);
}

EffectiveValues::EffectiveValues(schema::Catalogue catalogue)
    : catalogue_(std::move(catalogue)), entry_of_slot_(catalogue_.slot_count(), 0) {}

EffectiveValues::EffectiveValues(LoadedList const* default_list, LoadedList const& axis_list)
    : EffectiveValues(axis_list.catalogue) {
  lists_ = {&axis_list, default_list};
}

EffectiveValue& EffectiveValues::add(EffectiveValue value) const {
  if (blocks_.empty() || blocks_.back().size() == block_size) blocks_.emplace_back().reserve(block_size);
  std::vector<EffectiveValue>& block = blocks_.back();
  std::size_t const entry = (blocks_.size() - 1) * block_size + block.size() + 1;
  assert(entry <= schema::most_slots);
  entry_of_slot_[static_cast<std::size_t>(value.slot)] = static_cast<std::uint16_t>(entry);
  return block.emplace_back(value);
}

EffectiveValue const& EffectiveValues::look_up(schema::Slot slot) const {
  for (LoadedList const* const list : lists_) {
    if (list == nullptr) continue;
    std::uint32_t const last = list->line_values.last_of(slot);
    if (last != 0) return add(value_of_line(*list, last - 1));
  }
  return add(make_default(catalogue_, slot));
}

std::vector<EffectiveValue const*> EffectiveValues::set_values() const {
  std::vector<EffectiveValue const*> values;
  for (LoadedList const* const list : {lists_[1], lists_[0]}) {
    if (list == nullptr) continue;
    for (std::size_t i = 0; i < list->line_values.size(); ++i) {
      auto const slot = list->line_values.slot(i);
      if (!slot) continue;
      EffectiveValue const& value = (*this)[*slot];
      bool const counts = value.source == list->source && value.line == list->tree.assignments[i].line;
      if (counts) values.push_back(&value);
    }
  }
  // Lines that were meant for a parameter but are not assignments.
  std::size_t const assigned = values.size();
  for (std::vector<EffectiveValue> const& block : blocks_) {
    for (EffectiveValue const& value : block) {
      if (value.set() && !value.has_value) values.push_back(&value);
    }
  }
  if (values.size() != assigned) {
    std::sort(values.begin(), values.end(),
              [](EffectiveValue const* a, EffectiveValue const* b) { return stands_before(*a, *b); });
  }
  return values;
}

EffectiveValue const& EffectiveValues::at(std::string_view pattern, std::uint32_t first_index,
                                          std::uint32_t second_index) const {
  auto const find = [this](std::string_view name) { return catalogue_.find_exact(name); };
  return (*this)[find_pattern(pattern, first_index, second_index, find).slot];
}

EffectiveValue& EffectiveValues::edit(schema::Slot slot) {
  std::size_t const entry = entry_of_slot_[static_cast<std::size_t>(slot)];
  return entry != 0 ? value_at(entry - 1) : add(make_default(catalogue_, slot));
}

void EffectiveValues::refer(schema::Slot slot, schema::Slot target, schema::Value value) {
  edit(target).is_target = true;
  EffectiveValue& entry = edit(slot);
  entry.value = value;
  entry.referenced = true;
  referenced_slots_.push_back(slot);
}

schema::Parameter const& row_at(std::string_view pattern) {
  return *find_pattern(pattern, 0, 0, schema::find_exact).row;
}

}  // namespace axisc::validator
