// B3: the answer of a chain to a step, followed until next to nothing is left, with bounds of what is left.
#pragma once

#include "runtime/bounds/chain.hpp"

#include <stdint.h>

namespace axisc::runtime::bounds {

inline constexpr uint32_t longest_response = 1U << 22U;

/// Sums over all cycles of the magnitudes of a signal, and of its changes from one cycle to the next: the
/// most that it reaches for every unit of the largest increment of the setpoint, and of its largest distance
/// from rest.
struct Size {
  double increment, position;
};

/// Sizes of the signals of a section: its input d, and de, e, r.
struct SectionSizes {
  Size d, de, e, r;
};

struct Response {
  uint32_t cycles;   ///< N, a multiple of 64
  bool ended;        ///< what is left changes nothing that counts
  double gain;       ///< sum of |h| of the N cycles
  double gain_rest;  ///< at most so much is left
  double distance;   ///< sum of |s - H(1)| of the N cycles
  double distance_rest;
  double highest;                        ///< largest s - H(1)
  Size output;                           ///< of the output's increment
  SectionSizes sections[most_sections];  ///< with what is left
};

/// The taps of `kernel`, then the filters. Sums over cycles are compensated, and exact to 2 u. Cost: some
/// 10 ns per section and cycle, at most longest_response cycles.
void follow_response(Chain const& chain, KernelPart const& kernel, Response& response);

/// The same cycles once more, with what roundings took from each number: next to nothing is missing from
/// gain, distance and highest then. `sections` are the sizes of what was lost, over these cycles alone. Cost:
/// some five times as much.
void repeat_response(Chain const& chain, KernelPart const& kernel, uint32_t cycles, Response& response);

}  // namespace axisc::runtime::bounds
