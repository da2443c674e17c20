// Parameters that change how the control plans a path, but no plan of ours.
#pragma once

#include "configuration/machine/machine.hpp"
#include "validator/loading/loading.hpp"

#include <vector>

namespace axisc::validator {

/// Of an axis: the acceleration characteristic (P-AXIS-00202), dynamic weighting (00431) and limits of the
/// jerk (00561 to 00563), where a list sets them to something else than 0.
[[nodiscard]] std::vector<machine::UncomputedParameter> uncomputed_parameters(EffectiveValues const& values,
                                                                              SourceSet const& sources);
/// Of a channel.
[[nodiscard]] std::vector<machine::UncomputedParameter> uncomputed_parameters(LoadedGroup const& group,
                                                                              SourceSet const& sources);

}  // namespace axisc::validator
