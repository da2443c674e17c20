// Internal defaults, then the default list, then the axis' own list: what the control would run with, and
// why.
#pragma once

#include "diagnostics/source_text.hpp"
#include "grammar/axis_list.hpp"
#include "schema/catalogue.hpp"
#include "validator/reading.hpp"
#include "validator/value.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::validator {

/// A list that was read: its source, its tree, its role, and what each assignment means.
struct LoadedList {
  SourceId source{};
  schema::Catalogue catalogue;
  grammar::AxisList tree;
  bool is_default_list = false;
  Readings readings;  ///< one per assignment of the tree
  std::vector<LostAssignment> lost;
};

enum class Origin : std::uint8_t { internal_default, default_list, axis_list };

/// One concrete parameter of one axis.
struct EffectiveValue {
  schema::Parameter const* row = nullptr;  ///< of the slot; never null in EffectiveValues
  Value value;
  Span name_span;  ///< in the list that counts
  Span value_span;
  SourceId source{};
  std::uint32_t line = 0;
  schema::Slot slot{};
  Origin origin = Origin::internal_default;
  bool has_value = false;  ///< the line that counts could be read as name and value: `value_span` is one
  /// A list sets the parameter, but the line cannot be used (it has a finding of its own). Rules that need
  /// the value stay silent: one mistake, one message. `value` is then that of the earlier stage.
  bool unusable = false;
  bool referenced = false;  ///< the value came through a reference to another parameter

  [[nodiscard]] bool set() const { return origin != Origin::internal_default; }
  /// The token in the list that counts; none for the internal default.
  [[nodiscard]] std::optional<Place> value_place() const {
    if (!has_value) return std::nullopt;
    return Place{.source = source, .span = value_span};
  }
  /// The same of the name.
  [[nodiscard]] std::optional<Place> name_place() const {
    if (!set()) return std::nullopt;
    return Place{.source = source, .span = name_span};
  }
};

/// True where a list gives the parameter a value that differs from its documented default. A value equal to the default
/// means "not configured".
[[nodiscard]] bool configured(EffectiveValue const& value);

/// All parameters of one axis that a list sets, and the documented defaults of the others.
class EffectiveValues {
 public:
  explicit EffectiveValues(schema::Catalogue catalogue = {});
  /// Value of one slot. Cost: constant.
  [[nodiscard]] EffectiveValue const& operator[](schema::Slot slot) const {
    std::uint32_t const entry = entry_of_slot_[static_cast<std::size_t>(slot)];
    return entry == 0 ? internal_default(slot) : entries_[entry - 1];
  }
  /// By name, for rules: at("filter[].order", 1). The name is a pattern of the catalogue, the indices are in
  /// range.
  [[nodiscard]] EffectiveValue const& at(std::string_view pattern, std::uint32_t first_index = 0,
                                         std::uint32_t second_index = 0) const;
  [[nodiscard]] schema::Parameter const& row(schema::Slot slot) const { return *(*this)[slot].row; }
  [[nodiscard]] schema::Catalogue const& catalogue() const { return catalogue_; }
  /// What lists set, once order_set_values() was called in the order in which the lines that count stand (default list
  /// first).
  [[nodiscard]] std::span<EffectiveValue const> set_values() const { return entries_; }
  /// Those whose value came through a reference.
  [[nodiscard]] std::vector<schema::Slot> const& referenced_slots() const { return referenced_slots_; }

  /// What lists set for a slot; null where none does.
  [[nodiscard]] EffectiveValue const* find_set(schema::Slot slot) const {
    std::uint32_t const entry = entry_of_slot_[static_cast<std::size_t>(slot)];
    return entry == 0 ? nullptr : &entries_[entry - 1];
  }

  /// The entry of a slot for writing; it starts as a copy of the internal default. Ends the validity of
  /// references.
  EffectiveValue& edit(schema::Slot slot);
  /// The same for who gives it a value in any case: a new entry has none yet. `row` is that of the slot.
  EffectiveValue& replace(schema::Slot slot, schema::Parameter const& row) {
    std::uint32_t& entry = entry_of_slot_[static_cast<std::size_t>(slot)];
    if (entry != 0) {
      in_order_ = false;
      return entries_[entry - 1];
    }
    EffectiveValue& added = entries_.emplace_back();
    added.row = &row;
    added.slot = slot;
    entry = static_cast<std::uint32_t>(entries_.size());
    return added;
  }
  /// The value of a reference, which was looked up.
  void refer(schema::Slot slot, Value value);
  /// Makes room for so many more entries. Ends the validity of references.
  void expect(std::size_t count);
  /// Brings set_values() into the order of the lines; call it after the last edit().
  void order_set_values();

 private:
  [[nodiscard]] EffectiveValue const& internal_default(schema::Slot slot) const;

  schema::Catalogue catalogue_;
  std::vector<EffectiveValue> own_defaults_;  ///< with schema files; without them all share one table
  std::vector<std::uint32_t> entry_of_slot_;  ///< 0: internal default, else index + 1 into entries_
  std::vector<EffectiveValue> entries_;
  std::vector<schema::Slot> referenced_slots_;
  bool in_order_ = true;  ///< entries_, as long as every line adds a parameter of its own
};

/// `filter[2].order`, and "P-AXIS-00140" or empty.
[[nodiscard]] std::string parameter_name(EffectiveValue const& value);
[[nodiscard]] std::string parameter_number(EffectiveValue const& value);

/// Row of a pattern of the built-in catalogue, `filter[].order`. Schema files move no slot of the families that are
/// compiled.
[[nodiscard]] schema::Parameter const& row_at(std::string_view pattern);

/// What is wrong with a reference (AX2010..AX2014; a value that does not fit the data type is AX2004).
enum class ReferenceTrouble : std::uint8_t {
  unresolvable,
  circular,
  wrong_type,
  wrong_index,
  other_unit,  ///< the only one that leaves the value usable
  out_of_data_range,
};

struct ReferenceProblem {
  ReferenceTrouble trouble{};
  schema::Slot slot{};       ///< the parameter whose value is the reference
  std::uint32_t p_axis = 0;  ///< what it names
  std::uint32_t index = 0;
  std::optional<schema::Slot> target;  ///< the parameter it means, where there is one
  double number = 0;                   ///< out_of_data_range: the value there
  std::vector<schema::Slot> circle;    ///< the other members of a circle
};

struct MergedValues {
  EffectiveValues values;
  std::vector<ReferenceProblem> reference_problems;
};

/// Internal defaults, default list (may be null), axis list; then the references. `rotary` chooses the units that
/// AX2014 compares; where it is not given, the lists' own axis type does. The catalogue is that of the lists. The values look
/// into the lists and their sources, which live longer. Cost: linear in the assignments.
[[nodiscard]] MergedValues merge_lists(LoadedList const* default_list, LoadedList const& axis_list,
                                       std::optional<bool> rotary);

}  // namespace axisc::validator
