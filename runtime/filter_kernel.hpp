// One filter of a chain: its sections or its delay, and the share of the signal that goes through them.
//
// A signal travels along a chain as base + sum and its increment d. At the chain's beginning the base is the
// setpoint itself, sum is zero, d the difference of two setpoints; at its end base + sum is rounded once, to
// the output. So the size of the position enters that one rounding only.
//
// passing    H(1) = 1.  The base stays, sum grows by what the sections add. At rest sum is zero and the output
//            is the setpoint, exactly. With a share s:
//            sum' = s sum_f + (1 - s) sum,  d' = s d_f + (1 - s) d
// blocking   H(1) = 0.  The sections' output e replaces the signal. Of the part beside the filter the base is
//            scaled:  base' + low = (1 - s) base in twice the precision,  sum' = s e + (1 - s) sum + low
// delay      H = z^-D.  A ring hands on base, sum and d of D cycles ago, bit for bit. The part beside it is
//            added as a distance from there:
//            base' = base_D,  sum' = s sum_D + (1 - s) ((base - base_D) + sum)
//
// s = 1 makes 1 - s an exact zero, so no form needs a special case for it.
#pragma once

#include "runtime/double_bits.hpp"
#include "runtime/section_kernel.hpp"
#include "runtime/twofold.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// Value base + sum, and its increment since the cycle before.
struct Signal {
  double base, sum, d;
};

[[nodiscard]] inline double value_of(Signal const& signal) {
  return signal.base + signal.sum;
}

enum class FilterKind : uint32_t { pass_through, passing_sections, blocking_sections, delay };

/// Fixed after create; `states`, `ring` and `oldest` point to what changes in a cycle.
struct Filter {
  FilterKind kind;
  uint32_t section_count;  ///< of the two kinds with sections
  uint32_t delay_cycles;   ///< of a delay; at least 1
  uint32_t reserved;
  Section const* sections;
  SectionState* states;
  Signal* ring;       ///< the last `delay_cycles` input signals
  uint32_t* oldest;   ///< where in the ring the oldest stands
  double share;       ///< s
  double direct;      ///< 1 - s
  double direct_low;  ///< what rounding took from it
};

[[nodiscard]] inline Signal join_passing(Filter const& filter, Signal const& in, CascadeSignal filtered) {
  return {.base = in.base,
          .sum = filter.share * filtered.sum + filter.direct * in.sum,
          .d = filter.share * filtered.d + filter.direct * in.d};
}

[[nodiscard]] inline Signal join_blocking(Filter const& filter, Signal const& in, CascadeSignal filtered) {
  Twofold const base = exact_product(filter.direct, in.base);
  double const low = base.low + filter.direct_low * in.base;
  return {.base = base.high,
          .sum = filter.share * filtered.sum + (filter.direct * in.sum + low),
          .d = filter.share * filtered.d + filter.direct * in.d};
}

[[nodiscard]] inline Signal join_delay(Filter const& filter, Signal const& in, Signal const& delayed) {
  double const distance = (in.base - delayed.base) + in.sum;
  return {.base = delayed.base,
          .sum = filter.share * delayed.sum + filter.direct * distance,
          .d = filter.share * delayed.d + filter.direct * in.d};
}

/// The signal that stood here `delay_cycles` ago; the present one takes its place.
[[nodiscard]] inline Signal exchange_oldest(Filter const& filter, Signal const& in) {
  uint32_t const position = *filter.oldest;
  uint32_t const next = position + 1;
  *filter.oldest = next & static_cast<uint32_t>(mask_if_less(next, filter.delay_cycles));
  Signal const delayed = filter.ring[position];
  filter.ring[position] = in;
  return delayed;
}

/// One cycle. Which path is taken depends on the image alone.
[[nodiscard]] inline Signal run_filter(Filter const& filter, Signal const& in) {
  CascadeSignal const cascade{.sum = in.sum, .d = in.d};
  switch (filter.kind) {
    case FilterKind::passing_sections:
      return join_passing(filter, in,
                          run_passing_cascade(filter.sections, filter.states, filter.section_count, cascade));
    case FilterKind::blocking_sections:
      return join_blocking(
          filter, in, run_blocking_cascade(filter.sections, filter.states, filter.section_count, cascade));
    case FilterKind::delay:
      return join_delay(filter, in, exchange_oldest(filter, in));
    case FilterKind::pass_through:
      break;
  }
  return in;
}

/// What comes out for a signal that has always been `in`, with in.d = 0. Does not touch the states.
[[nodiscard]] inline Signal steady_output(Filter const& filter, Signal const& in) {
  switch (filter.kind) {
    case FilterKind::passing_sections:
      return join_passing(filter, in, {.sum = in.sum, .d = 0});
    case FilterKind::blocking_sections:
      return join_blocking(filter, in, {.sum = 0, .d = 0});
    case FilterKind::delay:
      return join_delay(filter, in, in);
    case FilterKind::pass_through:
      break;
  }
  return in;
}

}  // namespace axisc::runtime
