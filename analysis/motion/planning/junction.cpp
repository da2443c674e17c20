#include "analysis/motion/planning/junction.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

/// Directions are computed from rounded end points.
constexpr double no_turn = 1e-12;

/// STEP: v |Δu| ≤ a(v u) T. Up to the changeover the first stage counts.
double stage_velocity(AxisRamp const& ramp, double turn, double share) {
  double const low = ramp.first / turn;
  if (low * share <= ramp.changeover) return low;
  return std::max(ramp.changeover / share, ramp.second / turn);
}

bool is_limited(machine::CornerReading reading, double before, double after) {
  if (reading == machine::CornerReading::per_cycle || before * after < 0) return true;
  bool const speeds_up = std::abs(after) > std::abs(before);
  return speeds_up == (reading == machine::CornerReading::up_only);
}

StepLimit steps_in_mode(BlockMode const& mode, Point const& before, Point const& after) {
  StepLimit lowest;
  if (!mode.limits_corners) return lowest;
  auto const lower = [&](std::size_t axis, double velocity) {
    if (velocity < lowest.velocity) lowest = {.velocity = velocity, .axis = axis};
  };
  for (std::size_t i = 0; i < mode.axis_count; ++i) {
    double const turn = std::abs(after[i] - before[i]);
    if (turn < no_turn || !is_limited(mode.corner, before[i], after[i])) continue;
    auto const& axis = mode.axes[i];
    if (mode.slope != machine::Slope::step) {
      lower(i, axis.corner_step / turn);
      continue;
    }
    double const share = std::max(std::abs(before[i]), std::abs(after[i]));
    lower(i, std::min(stage_velocity(axis.up, turn, share), stage_velocity(axis.down, turn, share)));
  }
  return lowest;
}

/// Acceleration per v² where a block begins or ends.
Point curvature_at(Segment const& path, double way) {
  Point curvature{};
  auto const* const arc = path.arc();
  if (arc == nullptr) return curvature;
  double const angle = arc->phase + arc->sweep * (way / arc->length);
  curvature[arc->first] = -std::cos(angle) / arc->curvature_radius();
  curvature[arc->second] = -std::sin(angle) / arc->curvature_radius();
  return curvature;
}

double curvature_in_mode(BlockMode const& mode, Point const& step) {
  if (!mode.limits_curvature_steps) return unlimited;
  double lowest = unlimited;
  for (std::size_t i = 0; i < mode.axis_count; ++i) {
    double const change = std::abs(step[i]);
    if (change > 0) lowest = std::min(lowest, mode.axes[i].curve_step / change);
  }
  return std::sqrt(lowest);
}

}  // namespace

StepLimit step_limit(PathBlock const& before, PathBlock const& after) {
  auto const u0 = before.direction_out();
  auto const u1 = after.direction_in();
  if (u0 == u1) return {};
  auto const first = steps_in_mode(*before.mode, u0, u1);
  if (before.mode == after.mode) return first;
  auto const second = steps_in_mode(*after.mode, u0, u1);
  return second.velocity < first.velocity ? second : first;
}

double corner_velocity(PathBlock const& before, PathBlock const& after) {
  double const least = std::min(before.mode->least_corner_velocity, after.mode->least_corner_velocity);
  return std::max(step_limit(before, after).velocity, least);
}

double curvature_velocity(PathBlock const& before, PathBlock const& after) {
  if (before.path.arc() == nullptr && after.path.arc() == nullptr) return unlimited;
  auto const step = minus(curvature_at(after.path, 0), curvature_at(before.path, before.length));
  return std::min(curvature_in_mode(*before.mode, step), curvature_in_mode(*after.mode, step));
}

JunctionLimit junction_limit(PathBlock const& before, PathBlock const& after) {
  bool const ends_with_block = before.mode->slope != machine::Slope::hsc && !before.mode->across_blocks;
  bool const is_late = before.brakes_late && ends_with_block && !(before.rapid && !after.rapid);
  JunctionLimit limit{.velocity = std::min(before.velocity, is_late ? after.velocity_within : after.velocity),
                      .cause = LimitedBy::braking};
  auto const lower = [&](double velocity, LimitedBy cause) {
    if (velocity < limit.velocity) limit = {.velocity = velocity, .cause = cause};
  };
  lower(corner_velocity(before, after), LimitedBy::corner);
  lower(curvature_velocity(before, after), LimitedBy::tangent_jerk);
  return limit;
}

}  // namespace axisc::motion
