// How the control passes a corner between two long straight lines: with the velocity that the steps of the
// axes allow (planning/junction.hpp), braked for it before and accelerated behind it.
//
// Planes are those of contour_predictions.hpp: the first axis of the path and another one, each of the others
// in turn. The corner lies on a cycle. HSC, too, has acceleration 0 there, because the corner limits the
// velocity (planning/hsc_stretches.hpp).
#pragma once

#include "analysis/motion/contour/contour_predictions.hpp"
#include "analysis/motion/planning/axis_mode.hpp"
#include "analysis/motion/planning/phase.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace axisc::motion {

struct CornerTask {
  double turn = 0;                 ///< change of direction in radians: 0 straight on, π back
  double feed = 0;                 ///< units per cycle
  double acceleration_factor = 1;  ///< ACC_FACT
};

/// One side of the corner: along at a velocity, and a ramp between it and the corner.
struct CornerLeg {
  Point direction{};
  double velocity = 0;      ///< units per cycle: the feed, or what the axes allow
  std::vector<Phase> ramp;  ///< in the order in which it is passed; empty without one
  double ramp_time = 0;     ///< cycles
  double ramp_way = 0;      ///< units
};

struct CornerPassage {
  CornerLeg before, behind;
  double velocity = 0;  ///< through the corner, units per cycle
  /// The axis of the path whose step makes the corner slower than the lines, if any does.
  std::optional<std::size_t> slowed_by = {};
  double step = 0;  ///< how much its velocity changes from one cycle to the next, units per cycle

  /// The place in the plane so many cycles after the corner, or before it.
  [[nodiscard]] Point setpoint_at(double cycles) const;
};

/// By plane. A path of one axis passes the corner as if a second one were like it.
[[nodiscard]] std::vector<CornerPassage> pass_corner(PathDynamics const& dynamics, CornerTask const& task);

/// Chains that reach further, in cycles, are not predicted: the cost grows with the square of the reach.
inline constexpr double longest_passage_reach = 2000;

/// What filters make of corners passed so, by plane: the largest figures of the planes, by axis of the path.
/// None where a chain reaches too far.
[[nodiscard]] std::optional<ContourFigures> predict_passage(std::span<ChainAnswer const> answers,
                                                            std::span<CornerPassage const> planes);

}  // namespace axisc::motion
