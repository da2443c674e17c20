// The recursion of a second-order section in increment form.
//
// For a section H(z) = (b0 + b1 z^-1 + b2 z^-2) / A(z), A(z) = 1 + a1 z^-1 + a2 z^-2, only what it adds to
// its input is computed, from the increments d[n] = x[n] - x[n-1] of its input:
//
//     H(1) = 1:  e = y - x = G d,  G = (p + q z^-1) / A,  p = b0 - 1, q = p + b1 - a1
//     H(1) = 0:  e = y     = G d,  G = (p + q z^-1) / A,  p = b0,     q = b0 + b1
//
// With k = 1 + a1 + a2 and b = 1 - a2, the distances of the poles from z = 1, A e = (p + q z^-1) d becomes
//
//     de = p d + r,   e += de,   r = de + q d - k e - b de
//
// (r is what the next cycle adds to p d: de[n+1] = p d[n+1] + q d[n] + (1 - b) de[n] - k e[n]). Every term is
// of the size of the motion, never of the position: next to z = 1 nothing cancels, and at rest e and r go to
// zero.
//
// One cancellation is left: at low frequencies p and q are close to -1 and 1, so that after a jump de and q d
// cancel each other, and their rounding error lasts as a velocity. With g = p + q = k G(1), which is as exact
// as p and q, the same recursion has only small terms:
//
//     de = p d + r,   e += de,   r += g d - k e - b de
//
// No subnormal numbers. Sums and differences of multiples of 2^-n are multiples of 2^-n, rounded or not, and
// a double with a magnitude of at least 2^-m is a multiple of 2^-(m + 52). So it is enough to begin with
// coarse multiples and to come back to them before products have made them finer than 2^-1022:
//
//     setpoints                                  0 or >= 2^-500              so multiples of 2^-552
//     p; g, k, b, shares, weights; tails         0 or >= 2^-44; 2^-62; 2^-128           2^-96; 2^-114; 2^-180
//     d, at every third section, and whatever leaves an operation            rounded to  2^-620
//     r, where it is used                                                    rounded to  2^-620
//     de, e and d after j sections, j <= 3       p d + r                                 2^-(620 + 96 j)
//     k e, g d, b de, share times a sum of e     e, d, de being multiples of 2^-908      2^-1022
//     base, its product with 1 - s and its rounding error (0 or >= 2^-108)               2^-780
//     what a kernel takes                        tail times d, fade weight (2^-85)       2^-885
//
// A number of 2^-513 and above is unchanged when (x + 2^-567) - 2^-567 rounds it to 2^-620; below that,
// states are taken as zero soon. States of a recording are refused if they are not such multiples
// (restore.cpp). Nothing here needs the processor to flush anything, and it makes no difference if it does.
//
// Bounds. States with |e| + |r| below 2^-500 become zero, so that none ends in a limit cycle of subnormal
// numbers; those above 2^200 or not finite too, so that no image that passed verification can overflow. Each
// section is looked at once in six cycles, and as many in every cycle as in any other. In between nothing
// runs away: for inputs up to M all states and increments of 18 sections are at most 2^123 M in the next
// cycle (|p|, |q| <= 64, k < 4, b < 2: a section's states grow by at most 11 M + 512 d, its increment by 65
// d), so that they stay below 2^200 2^738.
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

/// The values a cascade computes with: the increment of the signal, and what its sections add to the signal's
/// base.
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
  Real<Width> const de = p * d + (r - all<Width>(r_at_rest));
  Real<Width> const e = load_real<Width>(states) + de;
  store<Width>(states, e);
  store<Width>(states + Width, r + (g * d - k * e - b * de));
  return {e, de};
}

/// Sections that a signal may pass before its increment is put on the grid again.
inline constexpr uint32_t sections_between_grids = 3;

/// Sections with H(1) = 1: each adds to the signal.
template <uint32_t Width>
AXISRT_INLINE CascadeSignal<Width> run_passing(double const* coefficients, double* states, uint32_t count,
                                               CascadeSignal<Width> signal) {
  for (uint32_t i = 0; i < count; ++i) {
    CascadeSignal<Width> const added = run_section<Width>(coefficients, states, signal.d);
    signal.sum += added.sum;
    signal.d += added.d;
    if ((i + 1) % sections_between_grids == 0) signal.d = on_grid<Width>(signal.d);
    coefficients += coefficients_of_section * Width;
    states += states_of_section * Width;
  }
  return {on_grid<Width>(signal.sum), on_grid<Width>(signal.d)};
}

/// Sections with H(1) = 0: each replaces the signal.
template <uint32_t Width>
AXISRT_INLINE CascadeSignal<Width> run_blocking(double const* coefficients, double* states, uint32_t count,
                                                CascadeSignal<Width> signal) {
  for (uint32_t i = 0; i < count; ++i) {
    signal = run_section<Width>(coefficients + i * coefficients_of_section * Width,
                                states + i * states_of_section * Width, signal.d);
    if ((i + 1) % sections_between_grids == 0) signal.d = on_grid<Width>(signal.d);
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
  store<Width>(states + Width, select<Width>(is_good, r, all<Width>(r_at_rest)));
}

}  // namespace axisc::runtime::AXISRT_LEVEL
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)
