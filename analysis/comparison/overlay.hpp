// The liveliest part of a recording next to the answer of a chain.
#pragma once

#include "analysis/comparison/verdict.hpp"

#include <cstddef>
#include <vector>

namespace axisc::comparison {

struct Overlay {
  std::size_t first = 0;  ///< cycle of the first values
  std::vector<double> input, recorded;
  std::vector<double> computed;  ///< shifted by the delay; not a number where the chain's answer is not known
};

/// At most `cycles` of them. `delay_cycles`: by how much the recorded output lags the chain's, with fractions
/// of a cycle.
[[nodiscard]] Overlay overlay(Recording const& recording, Chain const& chain, double delay_cycles,
                              std::size_t cycles);

}  // namespace axisc::comparison
