// The recursion of a second-order section in increment form.
//
// Of a section H(z) = (b0 + b1 z^-1 + b2 z^-2) / A(z), A(z) = 1 + a1 z^-1 + a2 z^-2, only what it adds to its
// input is computed, from the increments d[n] = x[n] - x[n-1] of its input:
//
//     H(1) = 1:  e = y - x = G d,  G = (p + q z^-1) / A,  p = b0 - 1, q = p + b1 - a1
//     H(1) = 0:  e = y     = G d,  G = (p + q z^-1) / A,  p = b0,     q = b0 + b1
//
// With k = 1 + a1 + a2 and b = 1 - a2, the distances of the poles from z = 1, A e = (p + q z^-1) d becomes
//
//     de = p d + r,   e += de,   r = de + q d - k e - b de
//
// (r is what the next cycle adds to p d: de[n+1] = p d[n+1] + q d[n] + (1 - b) de[n] - k e[n]). Every term is of the
// size of the motion, never of the position: next to z = 1 nothing cancels, and at rest e and r go to zero.
//
// One cancellation is left: of low frequencies p and q are close to -1 and 1, so that after a jump de and q d take each
// other away, and what rounding left of them lasts as a velocity. With g = p + q = k G(1), which is as exact as p and q,
// the same recursion has only small terms:
//
//     de = p d + r,   e += de,   r += g d - k e - b de
//
// Bounds. States with |e| + |r| below 2^-500 become zero, so that none ends in a limit cycle of subnormal numbers; those
// above 2^200 or not finite too, so that no image that passed verification can overflow. Each section is looked at once in
// six cycles, and as many in every cycle as in any other. In between
// nothing runs away: of inputs up to M all states and increments of 18 sections are at most 2^123 M in the next cycle
// (|p|, |q| <= 64, k < 4, b < 2: a section's states grow by at most 11 M + 512 d, its increment by 65 d), so that they
// stay below 2^200 2^738.
#pragma once

#include "runtime/lanes/lanes_def.hpp"

// Pieces of a group are some thousand doubles: offsets in them fit into 32 bits.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result)
namespace axisc::runtime::AXISRT_LEVEL {

/// Value base + sum, and its increment since the cycle before.
template <uint32_t Width>
struct Signal {
  Real<Width> base, sum, d;
};

/// What a cascade computes with: the increment of the signal, and what its sections add to the signal's base.
template <uint32_t Width>
struct CascadeSignal {
  Real<Width> sum, d;
};

inline constexpr uint32_t coefficients_of_section = 4;
inline constexpr uint32_t states_of_section = 2;

/// One cycle of a section: its e and de.
template <uint32_t Width>
AXISRT_INLINE CascadeSignal<Width> run_section(double const* coefficients, double* states, Real<Width> d) {
  auto const p = load_real<Width>(coefficients);
  auto const g = load_real<Width>(coefficients + Width);
  auto const k = load_real<Width>(coefficients + 2 * Width);
  auto const b = load_real<Width>(coefficients + 3 * Width);
  auto const r = load_real<Width>(states + Width);
  Real<Width> const de = p * d + r;
  Real<Width> const e = load_real<Width>(states) + de;
  store<Width>(states, e);
  store<Width>(states + Width, r + (g * d - k * e - b * de));
  return {e, de};
}

/// Sections with H(1) = 1: each adds to the signal.
template <uint32_t Width>
AXISRT_INLINE CascadeSignal<Width> run_passing(double const* coefficients, double* states, uint32_t count,
                                               CascadeSignal<Width> signal) {
  for (uint32_t i = 0; i < count; ++i) {
    CascadeSignal<Width> const added = run_section<Width>(coefficients, states, signal.d);
    signal.sum += added.sum;
    signal.d += added.d;
    coefficients += coefficients_of_section * Width;
    states += states_of_section * Width;
  }
  return signal;
}

/// Sections with H(1) = 0: each replaces the signal.
template <uint32_t Width>
AXISRT_INLINE CascadeSignal<Width> run_blocking(double const* coefficients, double* states, uint32_t count,
                                                CascadeSignal<Width> signal) {
  for (uint32_t i = 0; i < count; ++i) {
    signal = run_section<Width>(coefficients + i * coefficients_of_section * Width,
                                states + i * states_of_section * Width, signal.d);
  }
  return signal;
}

template <uint32_t Width>
AXISRT_INLINE void bound_section(double* states) {
  auto const e = load_real<Width>(states);
  auto const r = load_real<Width>(states + Width);
  Real<Width> const size = magnitude<Width>(e) + magnitude<Width>(r);
  Bits<Width> const is_good = mask_if_at_most<Width>(all<Width>(smallest_state), size) &
                              mask_if_at_most<Width>(size, all<Width>(largest_state));
  store<Width>(states, keep<Width>(is_good, e));
  store<Width>(states + Width, keep<Width>(is_good, r));
}

}  // namespace axisc::runtime::AXISRT_LEVEL
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)
