// A moving average in a few operations, whatever its order.
//
// Its tails are a ramp, S_j = s (K - j) for j = 0..K-1. Time is cut into windows of K cycles, and
//
//     E[n] / s = sum of (K - j) d[n-j] = C[n] + G[n]
//
// C is the contribution of the increments of the present window, G the rest of those before it:
//
//     C[n] = C[n-1] - P[n-1] + K d[n],   P[n] = P[n-1] + d[n]
//     G[n] = G[n-1] - Q[n-1],            Q[n] = Q[n-1] - d[n-K]
//
// At the end of a window, G takes the value of C and Q that of P, and C and P begin at zero again. No sum
// lives longer than two windows, so nothing drifts: the error stays below 2 K rounding errors of E, and at
// rest every sum ends at zero.
#pragma once

#include "runtime/lanes/taps_def.hpp"

// Pieces of a group are some thousand doubles: offsets in them fit into 32 bits.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result)
namespace axisc::runtime::AXISRT_LEVEL {

/// Where the present cycle's increment is in the history.
AXISRT_INLINE uint32_t place_in_history(SlotGroup const& slot) {
  return slot.block * block_cycles + slot.phase;
}

/// The increment of `age` cycles before the present one, whose place is given.
template <uint32_t Width>
AXISRT_INLINE double const* increment_of_age(SlotGroup const& slot, double const* history, uint32_t present,
                                             uint32_t age) {
  uint32_t const length = slot.block_count * block_cycles;
  return history + (present >= age ? present - age : present + length - age) * Width;
}

template <uint32_t Width>
AXISRT_INLINE Real<Width> run_ramp(SlotGroup& slot, double* sums, double const* history, uint32_t present,
                                   Real<Width> d) {
  Kernel const& kernel = *slot.common;
  uint32_t const length = kernel.tail_count;
  auto c = load_real<Width>(sums);
  auto p = load_real<Width>(sums + Width);
  auto g = load_real<Width>(sums + 2 * Width);
  auto q = load_real<Width>(sums + 3 * Width);
  g -= q;
  q -= load_real<Width>(increment_of_age<Width>(slot, history, present, length));
  c = (c - p) + kernel.length * d;
  p += d;
  Real<Width> const removed = rounded<Width>(kernel.ramp * (c + g));
  slot.ramp_phase += 1;
  if (slot.ramp_phase == length) {
    slot.ramp_phase = 0;
    g = c;
    q = p;
    c = Real<Width>{};
    p = Real<Width>{};
  }
  store<Width>(sums, c);
  store<Width>(sums + Width, p);
  store<Width>(sums + 2 * Width, g);
  store<Width>(sums + 3 * Width, q);
  return removed;
}

/// Takes the increments so far as those of the window before.
template <uint32_t Width>
AXISRT_APART void begin_ramp(SlotGroup& slot, double* sums, double const* history) {
  uint32_t const length = slot.common->tail_count;
  uint32_t const present = place_in_history(slot);
  Real<Width> g{};
  Real<Width> q{};
  for (uint32_t j = 0; j < length; ++j) {
    auto const d = load_real<Width>(increment_of_age<Width>(slot, history, present, j));
    g += static_cast<double>(length - j) * d;
    q += d;
  }
  store<Width>(sums, Real<Width>{});
  store<Width>(sums + Width, Real<Width>{});
  store<Width>(sums + 2 * Width, g);
  store<Width>(sums + 3 * Width, q);
  slot.ramp_phase = 0;
}

}  // namespace axisc::runtime::AXISRT_LEVEL
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)
