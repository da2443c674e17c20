// The linear-phase filter of an axis, with a fade from one kernel to another.
//
// A kernel is stored as tail sums, and what it takes from the signal is
//
//     E[n] = S_0 d[n] + S_1 d[n-1] + ... ,   y[n] = x[n] - E[n]
//
// with the increments d of the signal: at rest every d is zero, E is zero and y is x, exactly, whatever was rounded
// before. All kernels of a slot share one history of increments, so that any of them can begin at any time.
//
// A fade over F cycles goes from kernel A to kernel B by
//
//     E = E_A + w (E_B - E_A),  w = t^3 (10 - 15 t + 6 t^2),  t = 1/F, 2/F, ... 1
//
// whose first and second derivatives begin and end at zero: |w'| <= 15/(8 F), |w''| <= 10/(sqrt(3) F^2).
#pragma once

#include "runtime/double_bits.hpp"
#include "runtime/filter_kernel.hpp"
#include "runtime/limits.hpp"

#include <stdint.h>

namespace axisc::runtime {

/// No tails: the signal passes unchanged.
struct Kernel {
  double const* tails;
  uint32_t tail_count;
  uint32_t reserved;
};

struct SlotState {
  Kernel const* from;      ///< what worked before the fade; `to` when none runs
  Kernel const* to;        ///< what works, or begins to
  uint32_t fade_position;  ///< cycles of the fade that are done; fade_length when none runs
  uint32_t fade_length;
  uint32_t newest;       ///< where in the history the latest increment stands
  uint32_t rest_cycles;  ///< cycles without an increment, at most the history's length
  double removed;        ///< E of the cycle before
  uint32_t on;           ///< 1: the filter is switched on
  uint32_t reserved;
};

/// Fixed after create.
struct Slot {
  SlotState* state;
  /// The latest `history_length` increments, newest first from `newest` on; stored twice, one copy behind the other, so
  /// that they are always consecutive.
  double* history;
  uint32_t history_length;  ///< at least 1
  uint32_t family;
  Kernel const* listed;  ///< of the lists' values
  uint32_t on_at_start;
  uint32_t reserved;
};

[[nodiscard]] inline bool is_fading(SlotState const& state) {
  return state.fade_position < state.fade_length;
}

/// True where switching kernels cannot be seen in the output.
[[nodiscard]] inline bool is_at_rest(Slot const& slot) {
  return slot.state->rest_cycles >= slot.history_length;
}

/// Four sums side by side; the order of additions depends on the kernel's length alone.
[[nodiscard]] inline double removed_by(Kernel const& kernel, double const* increments) {
  double const* const tails = kernel.tails;
  double sum_0 = 0;
  double sum_1 = 0;
  double sum_2 = 0;
  double sum_3 = 0;
  uint32_t j = 0;
  for (; j + 4 <= kernel.tail_count; j += 4) {
    sum_0 += tails[j] * increments[j];
    sum_1 += tails[j + 1] * increments[j + 1];
    sum_2 += tails[j + 2] * increments[j + 2];
    sum_3 += tails[j + 3] * increments[j + 3];
  }
  for (; j < kernel.tail_count; ++j) sum_0 += tails[j] * increments[j];
  return (sum_0 + sum_1) + (sum_2 + sum_3);
}

[[nodiscard]] inline double fade_weight(uint32_t position, uint32_t length) {
  double const t = static_cast<double>(position) / static_cast<double>(length);
  return t * t * t * (10 + t * (6 * t - 15));
}

/// Puts d in front and returns the increments, newest first.
[[nodiscard]] inline double const* remember(Slot const& slot, double d) {
  SlotState& state = *slot.state;
  uint32_t const position = (state.newest == 0 ? slot.history_length : state.newest) - 1;
  state.newest = position;
  slot.history[position] = d;
  slot.history[position + slot.history_length] = d;
  auto const rests = static_cast<uint32_t>(mask_if_below(d, standstill_increment));
  auto const counts = static_cast<uint32_t>(mask_if_less(state.rest_cycles, slot.history_length));
  state.rest_cycles = (state.rest_cycles + (1 & counts)) & rests;
  return slot.history + position;
}

/// One cycle. Costs one kernel, during a fade two; that depends on commands, never on values.
[[nodiscard]] inline Signal run_slot(Slot const& slot, Signal const& in) {
  SlotState& state = *slot.state;
  double const* const increments = remember(slot, in.d);
  double removed = removed_by(*state.to, increments);
  if (is_fading(state)) {
    double const before = removed_by(*state.from, increments);
    state.fade_position += 1;
    double const w = fade_weight(state.fade_position, state.fade_length);
    removed = is_fading(state) ? before + w * (removed - before) : removed;
    if (!is_fading(state)) state.from = state.to;
  }
  Signal const out{.base = in.base, .sum = in.sum - removed, .d = in.d - (removed - state.removed)};
  state.removed = removed;
  return out;
}

/// The steady state for any constant signal; a fade has ended.
inline void reset_slot(Slot const& slot) {
  for (uint32_t i = 0; i < 2 * slot.history_length; ++i) slot.history[i] = 0;
  SlotState& state = *slot.state;
  state.from = state.to;
  state.fade_position = state.fade_length;
  state.newest = 0;
  state.rest_cycles = slot.history_length;
  state.removed = 0;
}

/// Begins to work with `kernel`; without a fade where `fade_cycles` is 0.
inline void switch_slot(Slot const& slot, Kernel const* kernel, uint32_t fade_cycles) {
  SlotState& state = *slot.state;
  state.to = kernel;
  state.fade_length = fade_cycles;
  state.fade_position = 0;
  if (fade_cycles == 0) state.from = kernel;
}

}  // namespace axisc::runtime
