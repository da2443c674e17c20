// Improved Position Control as lines of an axis list.
#pragma once

#include "analysis/tuning/suggestion/list_lines.hpp"

#include <string>
#include <vector>

namespace axisc::tuning {

/// enable, limit, and each stage with all its parameters, in the older spelling.
[[nodiscard]] std::vector<ListLine> control_lines(machine::PositionControl const& control);

/// "DIRECT 54 Hz, order 1, quality 10, weight 0.62 + INDIRECT 11 Hz, order 1, quality 2, damping 0.8, weight
/// 1.75".
[[nodiscard]] std::string short_name(machine::PositionControl const& control, Language language);

}  // namespace axisc::tuning
