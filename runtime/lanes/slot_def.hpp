// The linear-phase filter of an axis, with a fade from one kernel to another.
//
//     y[n] = x[n] - E[n]
//
// with E of the increments d of the signal (taps_def.hpp): at rest every d is zero, E is zero and y is x,
// exactly, whatever was rounded before. All kernels of a slot share one history of increments, so that any of
// them can begin at any time.
//
// A fade over F cycles goes from kernel A to kernel B by
//
//     E = E_A + w (E_B - E_A),  w = t^3 (10 - 15 t + 6 t^2),  t = 1/F, 2/F, ... 1
//
// whose first and second derivatives begin and end at zero: |w'| <= 15/(8 F), |w''| <= 10/(sqrt(3) F^2).
//
// Meanwhile both kernels are applied to the whole history (SlotMode::direct). Afterwards, from the beginning
// of a block on, the next block's outputs are prepared, and from the block after it they are used. The choice
// depends on commands and on time, never on values.
#pragma once

#include "runtime/lanes/ramp_def.hpp"
#include "runtime/lanes/sections_def.hpp"

// Pieces of a group are some thousand doubles: offsets in them fit into 32 bits.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result)
namespace axisc::runtime::AXISRT_LEVEL {

template <uint32_t Width>
inline constexpr bool works_in_blocks = Width > widest_by_one;

AXISRT_INLINE double fade_weight(uint32_t position, uint32_t length) {
  double const t = static_cast<double>(position) / static_cast<double>(length);
  return t * t * t * (10 + t * (6 * t - 15));
}

/// Moves every lane's fade on by a cycle; returns the lanes' w, and a mask of those that still fade.
template <uint32_t Width>
AXISRT_INLINE void advance_fades(SlotGroup& slot, double* weights, uint64_t* fades) {
  uint32_t fading = 0;
  for (uint32_t lane = 0; lane < Width; ++lane) {
    weights[lane] = 0;
    fades[lane] = 0;
    if (slot.fade_position[lane] == slot.fade_length[lane]) continue;
    slot.fade_position[lane] += 1;
    if (slot.fade_position[lane] < slot.fade_length[lane]) {
      weights[lane] = fade_weight(slot.fade_position[lane], slot.fade_length[lane]);
      fades[lane] = ~uint64_t{0};
      fading += 1;
    } else {
      slot.before[lane] = slot.kernel[lane];
    }
  }
  slot.fading = fading;
}

template <uint32_t Width>
AXISRT_INLINE Real<Width> apply_all_kernels(SlotGroup& slot, double const* history) {
  Real<Width> const removed = apply_directly<Width>(slot.to, slot, history);
  if (slot.fading == 0) return removed;
  double weights[Width];
  uint64_t fades[Width];
  advance_fades<Width>(slot, weights, fades);
  Real<Width> const before = apply_directly<Width>(slot.from, slot, history);
  Real<Width> const blend = before + load_real<Width>(weights) * (removed - before);
  return select<Width>(load_bits<Width>(fades), blend, removed);
}

template <uint32_t Width>
AXISRT_INLINE double* ahead_of(SlotGroup const& slot, double* parts, uint32_t for_next_block) {
  uint32_t const half = slot.next_ahead ^ (1U - for_next_block);
  return parts + (SlotParts::ahead + half * block_cycles) * Width;
}

template <uint32_t Width, bool Common>
AXISRT_INLINE Real<Width> apply_blocks(double const* zero, uint32_t blocks, SlotGroup const& slot,
                                       double* parts) {
  double const* const history = parts + SlotParts::history * Width;
  gather_ahead<Width, Common>(zero, reach_of(blocks), slot, history, ahead_of<Width>(slot, parts, 1));
  if (slot.mode == SlotMode::direct) return apply_directly<Width>(slot.to, slot, history);
  return apply_latest<Width, Common>(zero, slot, history, ahead_of<Width>(slot, parts, 0));
}

template <uint32_t Width>
AXISRT_INLINE Real<Width> removed_by_kernels(SlotGroup& slot, double* parts) {
  double const* const history = parts + SlotParts::history * Width;
  if constexpr (works_in_blocks<Width>) {
    if (slot.gathers != 0) {
      if (slot.common != nullptr) {
        return apply_blocks<Width, true>(slot.common->zero, slot.common->block_count, slot, parts);
      }
      return apply_blocks<Width, false>(slot.to, slot.block_count, slot, parts);
    }
  }
  return apply_all_kernels<Width>(slot, history);
}

/// Kernels that are not moving averages, or change over: apart, so that a moving average has all registers
/// for itself.
template <uint32_t Width>
AXISRT_APART void apply_kernels(SlotGroup& slot, double* parts, double* removed) {
  store<Width>(removed, removed_by_kernels<Width>(slot, parts));
}

template <uint32_t Width>
AXISRT_INLINE Real<Width> removed_in_cycle(SlotGroup& slot, double* parts, Real<Width> d) {
  if (slot.mode == SlotMode::ramp) {
    return run_ramp<Width>(slot, parts + SlotParts::ramp * Width, parts + SlotParts::history * Width,
                           place_in_history(slot), d);
  }
  double removed[Width];
  apply_kernels<Width>(slot, parts, removed);
  return load_real<Width>(removed);
}
/// The kernel of all lanes, or null.
AXISRT_INLINE Kernel const* common_kernel(SlotGroup const& slot) {
  for (uint32_t lane = 1; lane < slot.used; ++lane) {
    if (slot.kernel[lane] != slot.kernel[0]) return nullptr;
  }
  return slot.kernel[0];
}

/// Decides how the new block is done.
template <uint32_t Width>
AXISRT_APART void begin_block(SlotGroup& slot, double* parts) {
  if (slot.mode == SlotMode::ramp || slot.fading != 0 || !works_in_blocks<Width>) return;
  if (slot.gathers != 0) {
    slot.mode = SlotMode::blocked;
  } else {
    slot.common = common_kernel(slot);
    slot.gathers = 1;
  }
  slot.next_ahead ^= 1U;
  double* const next = ahead_of<Width>(slot, parts, 1);
  for (uint32_t i = 0; i < block_cycles; ++i) store<Width>(next + i * Width, Real<Width>{});
}

/// Moves on to the place of the next cycle's increment; true if a block begins there.
AXISRT_INLINE bool next_place(SlotGroup& slot) {
  slot.phase += 1;
  if (slot.phase < block_cycles) return false;
  slot.phase = 0;
  slot.block = slot.block + 1 == slot.block_count ? 0 : slot.block + 1;
  return true;
}

template <uint32_t Width>
AXISRT_INLINE void advance(SlotGroup& slot, double* parts) {
  if (slot.mode == SlotMode::direct && slot.fading == 0 && slot.gathers == 0) {
    Kernel const* const common = common_kernel(slot);
    if (common != nullptr && common->ramp != 0) {
      slot.common = common;
      slot.mode = SlotMode::ramp;
      begin_ramp<Width>(slot, parts + SlotParts::ramp * Width, parts + SlotParts::history * Width);
    }
  }
  if (next_place(slot)) begin_block<Width>(slot, parts);
}

template <uint32_t Width>
AXISRT_INLINE void remember(uint32_t present, double* parts, Real<Width> d) {
  store<Width>(parts + (SlotParts::history + present) * Width, d);
}

template <uint32_t Width>
AXISRT_INLINE Signal<Width> without(Real<Width> what, double* parts, Signal<Width> const& in) {
  Real<Width> const removed = on_grid<Width>(what);
  auto const removed_before = load_real<Width>(parts + SlotParts::removed * Width);
  store<Width>(parts + SlotParts::removed * Width, removed);
  return {in.base, in.sum - removed, in.d - (removed - removed_before)};
}

/// One cycle.
template <uint32_t Width>
AXISRT_INLINE Signal<Width> run_slot(SlotGroup& slot, double* parts, Signal<Width> const& in) {
  remember<Width>(place_in_history(slot), parts, in.d);
  Signal<Width> const out = without<Width>(removed_in_cycle<Width>(slot, parts, in.d), parts, in);
  advance<Width>(slot, parts);
  return out;
}

/// One cycle in SlotMode::ramp, without any call.
template <uint32_t Width>
AXISRT_INLINE Signal<Width> run_ramp_slot(SlotGroup& slot, double* parts, Signal<Width> const& in) {
  uint32_t const present = place_in_history(slot);
  remember<Width>(present, parts, in.d);
  Real<Width> const removed = run_ramp<Width>(slot, parts + SlotParts::ramp * Width,
                                              parts + SlotParts::history * Width, present, in.d);
  Signal<Width> const out = without<Width>(removed, parts, in);
  next_place(slot);
  return out;
}

}  // namespace axisc::runtime::AXISRT_LEVEL
// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)
