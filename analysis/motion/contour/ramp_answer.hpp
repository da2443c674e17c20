// The answer of a kernel to a ramp, from its taps.
#pragma once

#include <span>
#include <vector>

namespace axisc::motion {

/// r[n+1] = r[n] + Σ_{k≤n} b[k] of the causal taps b, from r[0] = 0 until one cycle after the last tap: what
/// chain_answer() takes.
[[nodiscard]] std::vector<double> ramp_answer(std::span<double const> taps);

}  // namespace axisc::motion
