// References between parameters of one axis: `P-AXIS-00212.0` as a value.
#pragma once

#include "validator/values/effective_values.hpp"

#include <unordered_map>
#include <vector>

namespace axisc::validator {

/// The problem of a reference (AX2010..AX2014; a value that does not fit the data type is AX2004).
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
  std::uint32_t p_axis = 0;  ///< the number in it
  std::uint32_t index = 0;
  std::optional<schema::Slot> target;  ///< the parameter it means, where there is one
  double number = 0;                   ///< out_of_data_range: the value there
  std::vector<schema::Slot> circle;    ///< the other members of a circle
};

/// Parameters whose value is a reference that still has to be looked up.
using PendingReferences = std::unordered_map<schema::Slot, Reference>;

/// Gives every pending parameter the value of its target, or makes it unusable and reports why. A parameter
/// whose target is itself unusable becomes so silently. Cost: linear; chains of any length are followed
/// without recursion.
[[nodiscard]] std::vector<ReferenceProblem> resolve_references(EffectiveValues& values,
                                                               PendingReferences const& pending, bool rotary);

}  // namespace axisc::validator
