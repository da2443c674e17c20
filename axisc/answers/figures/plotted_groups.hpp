// Channels of an input whose contours are drawn.
#pragma once

#include "axisc/answers/contour/contour_groups.hpp"
#include "axisc/answers/execution/group_chains.hpp"
#include "axisc/checking/compiled_input.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// Chains of the named group, of the first one without a name, with all FIR and HSC filters on. Of an image
/// without groups, all its axes. Failure for an unknown name.
[[nodiscard]] GroupChains group_chains(InputImage const& input, std::optional<std::string> const& name,
                                       ContourRequest const& wanted, std::string const& path);

[[nodiscard]] std::vector<std::string> axis_names(image::ImageContents const& contents,
                                                  machine::MachineGroup const& group);

}  // namespace axisc
