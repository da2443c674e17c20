// The distance of two signals, after the offset between them.
#pragma once

#include "analysis/comparison/verdict.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::comparison {

/// The power of ten of which all values are multiples, but those of the gaps; 0 where there is none down to a millionth.
[[nodiscard]] double resolution(Signal const& signal, std::span<std::size_t const> gaps);

/// What decides which cycles count.
struct Counting {
  std::size_t settling = 0;  ///< cycles after which the chain has forgotten an unknown start
  double output_resolution = 0;
};

/// Cycles where the output moves, the chain has settled since an unknown start, and no gap is near.
[[nodiscard]] std::vector<bool> counted_cycles(Recording const& recording, Counting const& counting);

/// Of `output` from `computed`. Among the offsets the smallest one that fits best.
[[nodiscard]] Residual residual_of(std::span<double const> computed, std::span<double const> output,
                                   std::vector<bool> const& counted);

/// Of a whole recording from the chain, also at parts of a cycle; memory does not grow with its length.
[[nodiscard]] Residual residual_of(Chain const& chain, Recording const& recording,
                                   std::vector<bool> const& counted);

}  // namespace axisc::comparison
