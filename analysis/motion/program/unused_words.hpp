// Words of a program that the path does not use.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/problems.hpp"

#include <string_view>

namespace axisc::motion {

/// Spindle, tool and M words are ignored with one note.
void ignore_technology(NcBlock const& block, Token const& token, ProgramProblems& problems);
/// A spindle speed, which is one of them unless a feed rate per revolution uses it (ProgramProblems::used()).
void note_speed(NcBlock const& block, Token const& token, ProgramProblems& problems);
/// A word with a number that means nothing to the channel: ignored where it is an axis, a spindle's or a tool's word, else
/// refused.
void take_unused_value(NcBlock const& block, Token const& token, std::string_view name,
                       ProgramProblems& problems);

}  // namespace axisc::motion
