// Planning across the ends of blocks (#SLOPE HSC; a reading, the manual says only that this slope plans so):
// TRAPEZ on stretches instead of blocks.
//
// Between stops there is at first one stretch, with the weakest acceleration and jerk of its blocks and the
// highest of their velocities. Where its motion exceeds limits, the lowest of them becomes a place with
// acceleration 0: both ends of a block that is too slow for it, or a junction. Stretches between places are
// planned as blocks are (velocity_window.hpp), until no limit is exceeded.
#pragma once

#include "analysis/motion/planning/phase.hpp"
#include "analysis/motion/planning/velocity_window.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::motion {

/// Blocks that are planned together. The next plan begins at the last place before the last `hsc_ahead` of
/// them.
inline constexpr std::size_t hsc_window = 4096;
inline constexpr std::size_t hsc_ahead = 1024;

/// An element of a stretch, with its share of the motion.
struct StretchPart {
  PassedElement passed;
  std::vector<Phase> phases;
  bool is_place = false;  ///< the acceleration is 0 at its end
};

/// `velocity` is that of the path before the first element, where its acceleration is 0. The path stops at
/// the end; `ends`: the program has nothing more. Cost: a few passes over the elements, at worst one for each
/// place.
/// An element whose number is given, and not 0, begins with acceleration 0 in any case.
[[nodiscard]] std::vector<StretchPart> plan_stretches(std::span<PathElement const> elements, double velocity,
                                                      bool ends, std::size_t place = 0);

}  // namespace axisc::motion
