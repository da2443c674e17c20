// The distance of two signals, after the offset between them.
#pragma once

#include "comparison/verdict.hpp"

#include <span>
#include <vector>

namespace axisc::comparison {

/// The power of ten of which all values are multiples, but those of the gaps; 0 where there is none down to a millionth.
[[nodiscard]] double resolution(std::span<double const> values, std::span<std::size_t const> gaps);

/// Cycles where the output moves, the chain has settled since an unknown start, and no gap is near.
[[nodiscard]] std::vector<bool> counted_cycles(Recording const& recording, std::size_t settling);

/// Of `output` from `computed`. Among the offsets the smallest one that fits best; `with_fractions`: also parts of a cycle.
[[nodiscard]] Residual residual_of(std::vector<double> const& computed, std::vector<double> const& output,
                                   std::vector<bool> const& counted, bool with_fractions);

}  // namespace axisc::comparison
