// The `#` commands that say how a path is driven: #SLOPE, #VECTOR LIMIT, #TRANSVELMIN, #CONTOUR MODE.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/state.hpp"
#include "schema/motion_words.hpp"

#include <cstddef>

namespace axisc::motion {

/// The row of the command that begins with this token; null where it is not one of them.
[[nodiscard]] schema::MotionWord const* motion_command_at(std::size_t at, NcBlock const& block);

/// Puts in force what the command says, which ends the block, or refuses it.
void take_motion_command(schema::MotionWord const& word, std::size_t at, NcBlock const& block,
                         ProgramState& state);

}  // namespace axisc::motion
