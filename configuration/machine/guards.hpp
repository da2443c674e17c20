// The Vibration Guards that the commands of a channel ask for.
#pragma once

#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <vector>

namespace axisc::machine {

/// Gives the axes of a channel that #VIB GUARD reaches, all but spindles, the guard that their lists
/// describe, switched off. An axis with another kernel keeps that: the control does not have both. Axes
/// without a usable guard get none. Slaves of a gantry outside the channel get that of their master (a
/// reading).
void add_guards(Machine& machine, std::size_t group);

/// The slaves of gantries whose master is in the channel, and which are in none themselves.
[[nodiscard]] std::vector<std::size_t> followers(Machine const& machine, MachineGroup const& group);

}  // namespace axisc::machine
