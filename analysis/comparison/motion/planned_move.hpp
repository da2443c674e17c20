// The setpoints of a move as the control would give them out, in one reading of what its manuals leave open.
#pragma once

#include "analysis/comparison/motion/program_moves.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace axisc::comparison {

/// From the rest before the move, a cycle apart, to its end. None where that takes more than `most` cycles.
[[nodiscard]] std::optional<std::vector<motion::Point>> planned_setpoints(Move const& move,
                                                                          motion::PathDynamics dynamics,
                                                                          Combination const& readings,
                                                                          std::size_t most);

}  // namespace axisc::comparison
