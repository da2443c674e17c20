// Some axes of a machine as a machine of its own, so that a question about a channel costs as much as the
// channel, not as the machine.
#pragma once

#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::machine {

struct MachinePart {
  /// The axes in the given order, then the gantry masters that they follow; the channels that have one of the
  /// axes, with these alone. Without lists and values, on which no motion depends.
  Machine machine;
  std::vector<std::size_t> groups;  ///< of each channel its index in the whole machine
};

/// `axes` are indices into Machine::axes, each named once.
[[nodiscard]] MachinePart part_of(Machine const& whole, std::span<std::size_t const> axes);

}  // namespace axisc::machine
