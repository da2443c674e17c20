// Setpoints and calls that leave nothing out.
#pragma once

#include "tests/runtime/c99/random_numbers.hpp"
#include "tests/runtime/c99/twins.hpp"

namespace axisc::test {

/// Moves both runtimes for so many cycles, or until they differ, with resets, commands and shifts of the
/// origin in between.
void move(Random& random, Twins& twins, int cycles);

}  // namespace axisc::test
