// #FILTER commands of a program.
#pragma once

#include "analysis/motion/path_listener.hpp"
#include "analysis/motion/program/channel.hpp"
#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/problems.hpp"

#include <optional>

namespace axisc::motion {

/// The change that this #FILTER token asks for; nothing where it was refused, each mistake with its place.
[[nodiscard]] std::optional<FilterChange> read_filter_change(NcBlock const& block, Token const& token,
                                                             ProgramChannel const& channel,
                                                             ProgramProblems& problems);

}  // namespace axisc::motion
