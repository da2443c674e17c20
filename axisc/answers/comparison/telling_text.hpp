// The NC program whose recording tells the readings of `motion`.
#pragma once

#include "configuration/machine/machine.hpp"
#include "diagnostics/sentence.hpp"

#include <cstddef>
#include <string>

namespace axisc {

/// The text of the program, with comments in that language: what each move is for, how far the axes go, what
/// cannot be told on this machine and what would tell it. `name` is the machine's in these comments.
[[nodiscard]] std::string telling_text(machine::Machine const& machine, std::size_t group,
                                       std::string const& name, Language language);

}  // namespace axisc
