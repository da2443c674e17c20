#include "validator/effective_values.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <memory>
#include <string>
#include <utility>

namespace axisc::validator {
namespace {

EffectiveValue make_default(schema::Catalogue const& catalogue, schema::Slot slot) {
  EffectiveValue value;
  value.slot = slot;
  value.row = &catalogue.parameter_of(slot);
  value.value = default_value(*value.row).value_or(Value{});
  return value;
}

std::vector<EffectiveValue> internal_defaults(schema::Catalogue const& catalogue) {
  std::vector<EffectiveValue> defaults;
  defaults.reserve(catalogue.slot_count());
  for (std::size_t i = 0; i < catalogue.slot_count(); ++i) {
    defaults.push_back(make_default(catalogue, static_cast<schema::Slot>(i)));
  }
  return defaults;
}

/// The defaults of the built-in catalogue, each made when it is first asked for: rules look at a hundred of them, and to
/// make them all would take as long as to read a list. Threads may make the same one, of which the first stays. They are
/// there until the program ends.
class BuiltInDefaults {
 public:
  BuiltInDefaults() : places_(schema::slot_count()) {}
  BuiltInDefaults(BuiltInDefaults const&) = delete;
  BuiltInDefaults& operator=(BuiltInDefaults const&) = delete;
  ~BuiltInDefaults() = delete;

  EffectiveValue const& operator[](schema::Slot slot) {
    std::atomic<EffectiveValue const*>& place = places_[static_cast<std::size_t>(slot)];
    EffectiveValue const* known = place.load(std::memory_order_acquire);
    if (known != nullptr) return *known;
    auto made = std::make_unique<EffectiveValue const>(make_default({}, slot));
    if (place.compare_exchange_strong(known, made.get(), std::memory_order_acq_rel)) return *made.release();
    return *known;
  }

 private:
  std::vector<std::atomic<EffectiveValue const*>> places_;
};

/// `filter[].order` with its indices.
std::string concrete_name(std::string_view pattern, std::uint32_t first_index, std::uint32_t second_index) {
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
  return name;
}

template <typename Find>
schema::NameLookup find_pattern(std::string_view pattern, std::uint32_t first_index,
                                std::uint32_t second_index, Find find) {
  bool const has_indices = pattern.find('[') != std::string_view::npos;
  schema::NameLookup const lookup =
      has_indices ? find(concrete_name(pattern, first_index, second_index)) : find(pattern);
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
  static BuiltInDefaults& built_in = *new BuiltInDefaults;
  return own_defaults_.empty() ? built_in[slot] : own_defaults_[static_cast<std::size_t>(slot)];
}

EffectiveValue const& EffectiveValues::at(std::string_view pattern, std::uint32_t first_index,
                                          std::uint32_t second_index) const {
  return (*this)[find_pattern(pattern, first_index, second_index, [this](std::string_view name) {
                   return catalogue_.find(name);
                 }).slot];
}

EffectiveValue& EffectiveValues::edit(schema::Slot slot) {
  bool const is_new = entry_of_slot_[static_cast<std::size_t>(slot)] == 0;
  EffectiveValue& entry = replace(slot, catalogue_.parameter_of(slot));
  if (is_new) entry.value = default_value(*entry.row).value_or(Value{});
  in_order_ = false;
  return entry;
}

void EffectiveValues::refer(schema::Slot slot, Value value) {
  EffectiveValue& entry = edit(slot);
  entry.value = value;
  entry.referenced = true;
  referenced_slots_.push_back(slot);
}

void EffectiveValues::expect(std::size_t count) {
  entries_.reserve(entries_.size() + std::min(count, catalogue_.slot_count()));
}

void EffectiveValues::order_set_values() {
  if (in_order_) return;
  // Not the entries themselves: those are large, and sorting moves what it sorts several times.
  struct Key {
    std::uint64_t line = 0;  ///< of the one that counts; then the slot
    std::uint32_t entry = 0;
  };
  std::vector<Key> keys;
  keys.reserve(entries_.size());
  for (EffectiveValue const& value : entries_) {
    std::uint64_t const line = std::uint64_t{static_cast<std::uint8_t>(value.origin)} << 48U |
                               std::uint64_t{value.line} << 16U | static_cast<std::uint16_t>(value.slot);
    keys.push_back({.line = line, .entry = static_cast<std::uint32_t>(keys.size())});
  }
  std::sort(keys.begin(), keys.end(), [](Key const& a, Key const& b) { return a.line < b.line; });
  std::vector<EffectiveValue> ordered;
  ordered.reserve(entries_.size());
  for (Key const& key : keys) {
    ordered.push_back(entries_[key.entry]);
    entry_of_slot_[static_cast<std::size_t>(ordered.back().slot)] =
        static_cast<std::uint32_t>(ordered.size());
  }
  entries_ = std::move(ordered);
  in_order_ = true;
}

schema::Parameter const& row_at(std::string_view pattern) {
  return *find_pattern(pattern, 0, 0, schema::find).row;
}

}  // namespace axisc::validator
