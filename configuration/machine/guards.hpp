// The Vibration Guards that the commands of a channel ask for.
#pragma once

#include "configuration/machine/machine.hpp"

#include <cstddef>

namespace axisc::machine {

/// Gives the axes of a channel that #VIB GUARD reaches, all but spindles, the guard that their lists
/// describe, switched off. An axis with another kernel keeps that: the control does not have both. Axes
/// without a usable guard get none.
void add_guards(Machine& machine, std::size_t group);

/// An axis of the channel has one.
[[nodiscard]] bool has_guard(Machine const& machine, MachineGroup const& group);

}  // namespace axisc::machine
