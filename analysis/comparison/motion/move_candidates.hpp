// Moves that may tell a reading of `motion`, as lines of an NC program.
#pragma once

#include "analysis/comparison/motion/reading_combinations.hpp"
#include "analysis/motion/planning/axis_mode.hpp"
#include "analysis/motion/program/channel.hpp"

#include <string>
#include <vector>

namespace axisc::comparison {

using NcLines = std::vector<std::string>;

/// For the key, gentle moves first; none where the channel lacks the axes for it. Each ends where it began.
[[nodiscard]] std::vector<NcLines> move_candidates(MotionKey key, motion::ProgramChannel const& channel,
                                                   motion::PathDynamics const& dynamics);

/// The rest between moves.
[[nodiscard]] std::string pause_line();

}  // namespace axisc::comparison
