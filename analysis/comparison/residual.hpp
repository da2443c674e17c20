// The distance of two signals, after the offset between them.
#pragma once

#include "analysis/comparison/verdict.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::comparison {

/// The power of ten of which all values outside the gaps are multiples; 0 where there is none down to a
/// millionth.
[[nodiscard]] double resolution(Signal const& signal, std::span<std::size_t const> gaps);

/// Conditions for a cycle to count.
struct Counting {
  std::size_t settling = 0;  ///< cycles after which the chain has forgotten an unknown start
  double output_resolution = 0;
};

/// Cycles where the output moves, the chain has settled since an unknown start, and no gap is near.
[[nodiscard]] std::vector<bool> counted_cycles(Recording const& recording, Counting const& counting);

/// The residual of `output` from `computed`, at the smallest of the offsets that fit best.
[[nodiscard]] Residual residual_of(std::span<double const> computed, std::span<double const> output,
                                   std::vector<bool> const& counted);

/// The residual of a whole recording from the chain, also at fractions of a cycle; memory does not grow with
/// its length.
[[nodiscard]] Residual residual_of(Chain const& chain, Recording const& recording,
                                   std::vector<bool> const& counted);

}  // namespace axisc::comparison
