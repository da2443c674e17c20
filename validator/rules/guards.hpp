// The guards that rules about Vibration Guard look at.
#pragma once

#include "validator/engine/rule.hpp"

#include <string_view>
#include <vector>

namespace axisc::validator::checks {

/// What a #VIB GUARD command gives an axis.
struct CommandedGuard {
  Place place;  ///< of the command's name
  std::string_view axis;
  design::KernelSpecification guard;
};

/// Of every command of the program that switches guards on or changes them, with the parameters that earlier
/// commands left in force; axes with the same guard once. None for a program that no channel runs.
[[nodiscard]] std::vector<CommandedGuard> commanded_guards(ProgramContext const& context);

/// A program of the machine, or its filter_sets, have a #VIB GUARD.
[[nodiscard]] bool commands_guard(LoadedMachine const& machine);

}  // namespace axisc::validator::checks
