// The language of NC programs once more, as a plain scanner by hand: an oracle for the grammar, written
// without it.
#pragma once

#include "grammar/nc_program.hpp"

#include <string_view>

namespace axisc::test {

/// What ProgramReader promises, with words.
void scan_nc_program(std::string_view bytes, grammar::ProgramListener& listener);

}  // namespace axisc::test
