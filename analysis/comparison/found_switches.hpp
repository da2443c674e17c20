// #FILTER commands not given with `--at`: cycles of a recording from which on the linear-phase filter is on
// or off.
#pragma once

#include "analysis/comparison/readings.hpp"
#include "analysis/comparison/verdict.hpp"

#include <vector>

namespace axisc::comparison {

/// Cycles in which the filter changes over.
struct ChangeOver {
  std::size_t on = 0, off = 0;
};

/// The switches between the kernel of the lists and none that explain the output best, by rising cycle; none
/// where the kernel is absent, or where the filter seems to stay as it is. compare() decides whether they
/// explain it well. Cost: two runs of the chain over the recording, both on and off; memory: 3 bytes a cycle.
[[nodiscard]] std::vector<KernelSwitch> found_switches(Recording const& recording,
                                                       Configured const& configured,
                                                       ChangeOver const& lengths);

}  // namespace axisc::comparison
