// Filters in series, with the linear-phase filter of the axis before or behind them.
#pragma once

#include "axisrt.h"
#include "runtime/double_bits.hpp"
#include "runtime/filter_kernel.hpp"
#include "runtime/kernel_slot.hpp"
#include "runtime/limits.hpp"

#include <stdint.h>

namespace axisc::runtime {

struct Chain {
  Filter const* filters;
  Slot const* before;  ///< HSC; null where there is none
  Slot const* behind;  ///< FIR; null where there is none
  uint32_t filter_count;
  uint32_t reserved;
};

struct ChainState {
  double input;   ///< the last good setpoint
  double output;  ///< 0 before the first reset
  double filter_output[AXISRT_MOST_FILTERS];
  Mask reset_done;  ///< all bits set after a reset
};

/// One cycle; returns the output.
[[nodiscard]] inline double run_chain(Chain const& chain, ChainState& state, double setpoint) {
  Signal signal{.base = setpoint, .sum = 0, .d = setpoint - state.input};
  double* output = state.filter_output;
  if (chain.before != nullptr) {
    signal = run_slot(*chain.before, signal);
    *output++ = value_of(signal);
  }
  for (uint32_t i = 0; i < chain.filter_count; ++i) {
    signal = run_filter(chain.filters[i], signal);
    *output++ = value_of(signal);
  }
  if (chain.behind != nullptr) {
    signal = run_slot(*chain.behind, signal);
    *output = value_of(signal);
  }
  state.input = setpoint;
  return value_of(signal);
}

/// What happened, as a number of axisrt_status. Everything that depends on values is selected, not branched to. A chain
/// that was never reset runs too, on the zeros of create, and its output is not used.
[[nodiscard]] inline Mask step_chain(Chain const& chain, ChainState& state, double in) {
  Mask const is_reset = state.reset_done;
  Mask const is_good = mask_if_within(in, largest_position);
  state.output = run_chain(chain, state, select(is_good & is_reset, in, state.input));
  Mask const status_if_reset = select(is_good, Mask{AXISRT_OK}, Mask{AXISRT_BAD_INPUT});
  return select(is_reset, status_if_reset, Mask{AXISRT_NOT_RESET});
}

[[nodiscard]] inline Mask worse(Mask a, Mask b) {
  return select(mask_if_less(a, b), b, a);
}

}  // namespace axisc::runtime
