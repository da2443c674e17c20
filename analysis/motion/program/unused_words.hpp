// Words of a program that the path does not use.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/problems.hpp"

#include <string_view>

namespace axisc::motion {

/// Spindle, tool and M words are ignored with one note.
void ignore_technology(NcBlock const& block, Token const& token, ProgramProblems& problems);
/// A spindle speed: ignored like those, unless a feed rate per revolution uses it (ProgramProblems::used()).
void note_speed(NcBlock const& block, Token const& token, ProgramProblems& problems);
/// A word with a number that means nothing to the channel: ignored if it is a word of an axis, a spindle or a
/// tool, refused otherwise.
void take_unused_value(NcBlock const& block, Token const& token, std::string_view name,
                       ProgramProblems& problems);

}  // namespace axisc::motion
