// Internal defaults, default list and axis list become the values of one axis.
#pragma once

#include "configuration/machine/machine.hpp"
#include "validator/values/effective_values.hpp"
#include "validator/values/references.hpp"

#include <optional>
#include <vector>

namespace axisc::validator {

struct MergedValues {
  EffectiveValues values;
  std::vector<ReferenceProblem> reference_problems;
};

/// The axis type in the lists: P-AXIS-00018.
[[nodiscard]] machine::AxisType axis_type_of(EffectiveValues const& values);

/// Internal defaults, default list (may be null), axis list; then the references. `rotary` chooses the units
/// that AX2014 compares; where it is not given, the lists' own axis type does. The catalogue is that of the
/// lists. The values look into the lists and their sources, which must outlive them. Cost: linear in the
/// assignments.
[[nodiscard]] MergedValues merge_lists(LoadedList const* default_list, LoadedList const& axis_list,
                                       std::optional<bool> rotary);

}  // namespace axisc::validator
