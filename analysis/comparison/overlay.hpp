// The liveliest part of a recording beside what a chain makes of it.
#pragma once

#include "analysis/comparison/verdict.hpp"

#include <cstddef>
#include <vector>

namespace axisc::comparison {

struct Overlay {
  std::size_t first = 0;  ///< cycle of the first values
  std::vector<double> input, recorded;
  std::vector<double> computed;  ///< moved by the delay; not a number where the chain's answer is not known
};

/// At most `cycles` of them. `delay_cycles`: of the recorded output behind the chain's, also with a part of a cycle.
[[nodiscard]] Overlay overlay(Recording const& recording, Chain const& chain, double delay_cycles,
                              std::size_t cycles);

}  // namespace axisc::comparison
