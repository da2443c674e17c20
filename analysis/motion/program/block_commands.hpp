// The `#` commands of a program other than #FILTER.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/state.hpp"

#include <cstddef>

namespace axisc::motion {

/// The command that is this token, which ends the block: those of motion_commands.hpp count; commands that
/// change neither path nor filters are ignored, all others refused.
void take_other_command(std::size_t at, NcBlock const& block, ProgramState& state);

}  // namespace axisc::motion
