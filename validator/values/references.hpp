// References between parameters of one axis: `P-AXIS-00212.0` as a value.
#pragma once

#include "validator/values/effective_values.hpp"

#include <unordered_map>
#include <vector>

namespace axisc::validator {

/// Parameters whose value is a reference that still has to be looked up.
using PendingReferences = std::unordered_map<schema::Slot, Reference>;

/// Gives every pending parameter the value of its target, or makes it unusable and says why. A parameter
/// whose target is itself unusable becomes so silently. Cost: linear; chains of any length are followed
/// without recursion.
[[nodiscard]] std::vector<ReferenceProblem> resolve_references(EffectiveValues& values,
                                                               PendingReferences const& pending, bool rotary);

}  // namespace axisc::validator
