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
// States of which both are smaller than 2^-500 become zero, so that none ends in a limit cycle of subnormal numbers.
// A state that is larger than 2^500 or not finite becomes zero, so that no image that passed verification can overflow:
// increments grow by a factor of at most 1 + 64 a section, 18 sections by less than 2^109, and 2^500 * 2^109 is finite.
// All of it is arithmetic on the bits, without a branch.
#pragma once

#include "runtime/double_bits.hpp"
#include "runtime/limits.hpp"

#include <bit>
#include <stdint.h>

namespace axisc::runtime {

/// Coefficients, shared by all filters with the same section.
struct Section {
  double p, g, k, b;
};

/// States, one per section of every filter. Zero is the steady state for any constant input.
struct SectionState {
  double e, r;
};

/// What a cascade computes with: the increment of the signal, and what its sections add to the signal's base.
struct CascadeSignal {
  double sum, d;
};

[[nodiscard]] inline SectionState bounded(SectionState state) {
  Mask const rests = mask_if_below(state.e, smallest_state) & mask_if_below(state.r, smallest_state);
  return {.e = keep(~rests & mask_if_within(state.e, largest_state), state.e),
          .r = keep(~rests & mask_if_within(state.r, largest_state), state.r)};
}

/// One cycle of a section: its e and de.
[[nodiscard]] inline CascadeSignal run_section(Section const& section, SectionState& state, double d) {
  double const de = section.p * d + state.r;
  double const e = state.e + de;
  double const r = state.r + (section.g * d - section.k * e - section.b * de);
  state = bounded({.e = e, .r = r});
  return {.sum = e, .d = de};
}

/// Sections with H(1) = 1: each adds to the signal.
[[nodiscard]] inline CascadeSignal run_passing_cascade(Section const* sections, SectionState* states,
                                                       uint32_t count, CascadeSignal signal) {
  for (uint32_t i = 0; i < count; ++i) {
    CascadeSignal const added = run_section(sections[i], states[i], signal.d);
    signal.sum += added.sum;
    signal.d += added.d;
  }
  return signal;
}

/// Sections with H(1) = 0: each replaces the signal.
[[nodiscard]] inline CascadeSignal run_blocking_cascade(Section const* sections, SectionState* states,
                                                        uint32_t count, CascadeSignal signal) {
  for (uint32_t i = 0; i < count; ++i) signal = run_section(sections[i], states[i], signal.d);
  return signal;
}

}  // namespace axisc::runtime
