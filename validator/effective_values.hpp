// Internal defaults, then the default list, then the axis' own list: what the control would run with, and why.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "diagnostics/source_text.hpp"
#include "grammar/axis_list.hpp"
#include "schema/catalogue.hpp"
#include "validator/value.hpp"

namespace axisc::validator {

/// A list that was read: its source, its tree, and its role.
struct LoadedList {
  SourceId source{};
  grammar::AxisList tree;
  bool is_default_list = false;
};

enum class Origin : std::uint8_t { internal_default, default_list, axis_list };

/// One concrete parameter of one axis.
struct EffectiveValue {
  schema::Slot slot{};
  Origin origin = Origin::internal_default;
  Value value;
  std::optional<Place> value_place;  ///< the token in the list that counts; none for the internal default
  std::optional<Place> name_place;
  std::uint32_t line = 0;
  /// A list sets the parameter, but the line cannot be used (it has a finding of its own). Rules that need the value
  /// stay silent: one mistake, one message. `value` is then that of the earlier stage.
  bool unusable = false;
  bool referenced = false;  ///< the value came through a reference to another parameter

  [[nodiscard]] bool set() const { return origin != Origin::internal_default; }
};

/// All parameters of one axis that a list sets, and the documented defaults of the others.
class EffectiveValues {
 public:
  EffectiveValues();
  /// Value of one slot. Cost: constant.
  [[nodiscard]] EffectiveValue const& operator[](schema::Slot slot) const;
  /// By name, for rules: at("filter[].order", 1). The name is a pattern of the catalogue.
  [[nodiscard]] EffectiveValue const& at(std::string_view pattern, std::uint32_t first_index = 0, std::uint32_t second_index = 0) const;
  /// What lists set, in the order of the lines (default list first).
  [[nodiscard]] std::vector<schema::Slot> const& set_slots() const { return set_slots_; }

  EffectiveValue& edit(schema::Slot slot);

 private:
  std::vector<std::uint32_t> entry_of_slot_;  ///< 0: internal default, else index + 1 into entries_
  std::vector<EffectiveValue> entries_;
  std::vector<schema::Slot> set_slots_;
};

}  // namespace axisc::validator
