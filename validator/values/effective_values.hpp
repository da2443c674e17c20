// Internal defaults, then the default list, then the axis' own list: the values that the control uses, and
// where they come from.
#pragma once

#include "configuration/machine/machine.hpp"
#include "design/readings.hpp"
#include "diagnostics/source_text.hpp"
#include "schema/catalogue.hpp"
#include "schema/value.hpp"
#include "validator/values/loaded_list.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::validator {

enum class Origin : std::uint8_t { internal_default, default_list, axis_list };

/// One concrete parameter of one axis.
struct EffectiveValue {
  schema::Parameter const* row = nullptr;  ///< of the slot; never null in EffectiveValues
  schema::Value value;
  Span name_span;  ///< in the list that counts
  Span value_span;
  SourceId source{};
  std::uint32_t line = 0;
  schema::Slot slot{};
  Origin origin = Origin::internal_default;
  bool has_value = false;  ///< the line that applies was read as name and value: `value_span` is valid
  /// A list sets the parameter, but the line cannot be used (it has a finding of its own). Rules that need
  /// the value stay silent: one mistake, one message. `value` is then the last usable one before that line.
  bool unusable = false;
  bool referenced = false;  ///< the value came through a reference to another parameter
  bool is_target = false;   ///< another parameter takes its value from this one, through a reference

  /// A flag that is usable and set.
  [[nodiscard]] bool is_on() const { return !unusable && value.flag(); }
  [[nodiscard]] bool set() const { return origin != Origin::internal_default; }
  /// The value token in the list that applies; none for the internal default.
  [[nodiscard]] std::optional<Place> value_place() const {
    if (!has_value) return std::nullopt;
    return Place{.source = source, .span = value_span};
  }
  /// The name token in the list that applies; none for the internal default.
  [[nodiscard]] std::optional<Place> name_place() const {
    if (!set()) return std::nullopt;
    return Place{.source = source, .span = name_span};
  }
};

/// True where a list gives the parameter a value that differs from its documented default. A value equal to
/// the default means "not configured".
[[nodiscard]] bool configured(EffectiveValue const& value);

/// All parameters of one axis that a list sets, and the documented defaults of the others. Values are created
/// on first access and never move: one EffectiveValues serves one thread at a time.
class EffectiveValues {
 public:
  explicit EffectiveValues(schema::Catalogue catalogue = {});
  /// Values from the lines of the lists; the first list may be null, and both must outlive this object. Lines
  /// without a value of their own are left to the caller, through edit().
  EffectiveValues(LoadedList const* default_list, LoadedList const& axis_list);
  /// Moving keeps the addresses of the values.
  EffectiveValues(EffectiveValues&&) noexcept = default;
  EffectiveValues& operator=(EffectiveValues&&) noexcept = default;
  EffectiveValues(EffectiveValues const&) = delete;
  EffectiveValues& operator=(EffectiveValues const&) = delete;
  ~EffectiveValues() = default;

  /// Value of one slot. Cost: constant.
  [[nodiscard]] EffectiveValue const& operator[](schema::Slot slot) const {
    std::size_t const entry = entry_of_slot_[static_cast<std::size_t>(slot)];
    return entry == 0 ? look_up(slot) : value_at(entry - 1);
  }
  /// By name, for rules: at("filter[].order", 1). The name is a pattern of the catalogue, the indices are in
  /// range.
  [[nodiscard]] EffectiveValue const& at(std::string_view pattern, std::uint32_t first_index = 0,
                                         std::uint32_t second_index = 0) const;
  [[nodiscard]] schema::Parameter const& row(schema::Slot slot) const {
    return catalogue_.parameter_of(slot);
  }
  [[nodiscard]] schema::Catalogue const& catalogue() const { return catalogue_; }
  /// How the control that uses the values computes its filters.
  [[nodiscard]] design::Readings const& readings() const { return readings_; }
  void read_as(design::Readings const& readings) { readings_ = readings; }
  /// A list sets the parameter, perhaps in a line that cannot be used.
  [[nodiscard]] bool is_set(schema::Slot slot) const {
    std::size_t const entry = entry_of_slot_[static_cast<std::size_t>(slot)];
    if (entry != 0) return value_at(entry - 1).set();
    auto const sets = [slot](LoadedList const* list) {
      return list != nullptr && list->line_values.last_of(slot) != 0;
    };
    return sets(lists_[0]) || sets(lists_[1]);
  }
  /// The values that lists set, in the order of the lines that apply, default list first. Cost: all of them
  /// are created and sorted.
  [[nodiscard]] std::vector<EffectiveValue const*> set_values() const;
  /// The values that came through a reference.
  [[nodiscard]] std::vector<schema::Slot> const& referenced_slots() const { return referenced_slots_; }

  /// The entry of a slot for writing. On first access it is a copy of the internal default, whatever lists
  /// set.
  EffectiveValue& edit(schema::Slot slot);
  /// Sets the value of a reference that was looked up: that of `target`, or of its default.
  void refer(schema::Slot slot, schema::Slot target, schema::Value value);

 private:
  /// Values lie in blocks that never grow, so that none of them moves.
  static constexpr std::size_t block_size = 64;

  EffectiveValue const& look_up(schema::Slot slot) const;
  /// Creates the entry of a slot that has none.
  EffectiveValue& add(EffectiveValue value) const;
  [[nodiscard]] EffectiveValue& value_at(std::size_t index) const {
    return blocks_[index / block_size][index % block_size];
  }

  schema::Catalogue catalogue_;
  design::Readings readings_;
  std::array<LoadedList const*, 2> lists_{};  ///< default list first; null if there is none
  /// 0: not yet looked at; else index + 1. There are at most schema::most_slots.
  mutable std::vector<std::uint16_t> entry_of_slot_;
  mutable std::vector<std::vector<EffectiveValue>> blocks_;
  std::vector<schema::Slot> referenced_slots_;
};

/// The value that a line of a list gives its parameter, which must be known.
[[nodiscard]] EffectiveValue value_of_line(LoadedList const& list, std::size_t assignment);

/// Whether the line that applies to `a` comes before that for `b`: by list, the default list first, then by
/// line.
[[nodiscard]] bool stands_before(EffectiveValue const& a, EffectiveValue const& b);

/// `filter[2].order`, and "P-AXIS-00140" or empty.
[[nodiscard]] std::string parameter_name(EffectiveValue const& value);
[[nodiscard]] std::string parameter_number(EffectiveValue const& value);

/// Row of a pattern of the built-in catalogue, `filter[].order`. Schema files move no slot of the families
/// that are compiled.
[[nodiscard]] schema::Parameter const& row_at(std::string_view pattern);

}  // namespace axisc::validator
