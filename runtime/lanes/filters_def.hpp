// One step of a chain: sections or a delay, and the share of the signal that goes through them.
//
// A signal travels along a chain as base + sum and its increment d. At the chain's beginning the base is the
// setpoint itself, sum is zero, d the difference of two setpoints; at its end base + sum is rounded once, to
// the output. So the size of the position enters that one rounding only.
//
// passing    H(1) = 1.  The base stays, sum grows by what the sections add. At rest sum is zero and
//            the output is the setpoint, exactly. With a share s:
//            sum' = s sum_f + (1 - s) sum,  d' = s d_f + (1 - s) d
// blocking   H(1) = 0.  The sections' output e replaces the signal. The base of the part that bypasses
//            the filter is scaled:
//            base' + low = (1 - s) base in twice the precision,  sum' = s e + (1 - s) sum + low
// delay      H = z^-D.  A ring hands on base, sum and d of D cycles ago, bit for bit. The part that
//            bypasses it is added as a distance from there:
//            base' = base_D,  sum' = s sum_D + (1 - s) ((base - base_D) + sum)
//
// s = 1 makes 1 - s an exact zero, so no form needs a special case for it.
#pragma once

#include "runtime/lanes/sections_def.hpp"

// Pieces of a group are some thousand doubles: offsets in them fit into 32 bits.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result)
namespace axisc::runtime::AXISRT_LEVEL {

/// s, 1 - s and its rounding error.
template <uint32_t Width>
struct Share {
  Real<Width> share, direct, direct_low;
};

inline constexpr uint32_t numbers_of_share = 3;

template <uint32_t Width>
AXISRT_INLINE Share<Width> load_share(double const* constants) {
  return {load_real<Width>(constants), load_real<Width>(constants + Width),
          load_real<Width>(constants + 2 * Width)};
}

template <uint32_t Width>
struct Twofold {
  Real<Width> high, low;
};

/// Upper and lower half of the digits.
template <uint32_t Width>
AXISRT_INLINE Twofold<Width> split(Real<Width> a) {
  constexpr double shift = 0x1p27 + 1;
  Real<Width> const shifted = rounded<Width>(shift * a);
  Real<Width> const high = shifted - (shifted - a);
  return {high, a - high};
}

/// high + low is the product, without loss (T. J. Dekker, 1971).
template <uint32_t Width>
AXISRT_INLINE Twofold<Width> exact_product(Real<Width> a, Real<Width> b) {
  Real<Width> const high = rounded<Width>(a * b);
  Twofold<Width> const a_half = split<Width>(a);
  Twofold<Width> const b_half = split<Width>(b);
  Real<Width> const crossed =
      (a_half.high * b_half.high - high) + a_half.high * b_half.low + a_half.low * b_half.high;
  return {high, crossed + a_half.low * b_half.low};
}

template <uint32_t Width>
AXISRT_INLINE Signal<Width> run_shared(Operation const& operation, double const* constants, double* states,
                                       Signal<Width> const& in) {
  Share<Width> const part = load_share<Width>(constants);
  CascadeSignal<Width> const filtered = run_passing<Width>(constants + numbers_of_share * Width, states,
                                                           operation.section_count, {in.sum, in.d});
  return {in.base, part.share * filtered.sum + part.direct * in.sum,
          part.share * filtered.d + part.direct * in.d};
}

template <uint32_t Width>
AXISRT_INLINE Signal<Width> run_blocking_filter(Operation const& operation, double const* constants,
                                                double* states, Signal<Width> const& in) {
  Share<Width> const part = load_share<Width>(constants);
  CascadeSignal<Width> const filtered = run_blocking<Width>(constants + numbers_of_share * Width, states,
                                                            operation.section_count, {in.sum, in.d});
  Twofold<Width> const base = exact_product<Width>(part.direct, in.base);
  Real<Width> const low = base.low + part.direct_low * in.base;
  return {on_grid<Width>(base.high), on_grid<Width>(part.share * filtered.sum + (part.direct * in.sum + low)),
          on_grid<Width>(part.share * filtered.d + part.direct * in.d)};
}

/// The ring has one place more than the delay, so that the delayed signal stays readable until the next
/// cycle.
template <uint32_t Width>
AXISRT_INLINE Signal<Width> run_delay(Operation const& operation, double const* constants, double* states,
                                      Signal<Width> const& in) {
  uint32_t const newest = operation.state->position;
  uint32_t const oldest = newest == operation.delay_cycles ? 0 : newest + 1;
  double* const to = states + 3 * Width * newest;
  store<Width>(to, in.base);
  store<Width>(to + Width, in.sum);
  store<Width>(to + 2 * Width, in.d);
  double const* const from = states + 3 * Width * oldest;
  Signal<Width> const delayed{load_real<Width>(from), load_real<Width>(from + Width),
                              load_real<Width>(from + 2 * Width)};
  Share<Width> const part = load_share<Width>(constants);
  Real<Width> const distance = (in.base - delayed.base) + in.sum;
  return {delayed.base, on_grid<Width>(part.share * delayed.sum + part.direct * distance),
          on_grid<Width>(part.share * delayed.d + part.direct * in.d)};
}

}  // namespace axisc::runtime::AXISRT_LEVEL
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)
