#include "analysis/motion/path_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace axisc::motion {
namespace {

/// A component this small is none: the axis rests.
constexpr double no_motion = 1e-15;

enum class Sense : std::uint8_t { up, down };

AxisRamp const& ramp_of(AxisMode const& axis, Sense sense) {
  return sense == Sense::up ? axis.up : axis.down;
}

/// Calls take(axis, share) for each axis that moves in a direction.
template <class Take>
void for_each_moving(BlockMode const& mode, Point const& direction, Take take) {
  for (std::size_t i = 0; i < mode.axis_count; ++i) {
    double const share = std::abs(direction[i]);
    if (share > no_motion) take(mode.axes[i], share);
  }
}

double highest_velocity(BlockMode const& mode, Point const& direction) {
  double lowest = unlimited;
  for_each_moving(mode, direction, [&](AxisMode const& axis, double share) {
    lowest = std::min(lowest, axis.velocity / share);
  });
  return lowest;
}

/// a(v) of STEP in a direction, at most `most`.
Ramp staircase(BlockMode const& mode, Point const& direction, Sense sense, double most) {
  std::array<AccelerationStep, most_axes + 1> steps{};
  std::size_t count = 1;
  for_each_moving(mode, direction, [&](AxisMode const& axis, double share) {
    steps[count++].above = ramp_of(axis, sense).changeover / share;
  });
  std::sort(steps.begin() + 1, steps.begin() + static_cast<std::ptrdiff_t>(count),
            [](AccelerationStep const& a, AccelerationStep const& b) { return a.above < b.above; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    // Halfway to the next step, where each axis is on one side of its changeover.
    double const v = i + 1 < count ? (steps[i].above + steps[i + 1].above) / 2 : 2 * steps[i].above + 1;
    double lowest = most;
    for_each_moving(mode, direction, [&](AxisMode const& axis, double share) {
      lowest = std::min(lowest, ramp_of(axis, sense).stage(v * share) / share);
    });
    bool const is_new = kept == 0 || steps[kept - 1].acceleration != lowest;
    bool const is_empty = i + 1 < count && steps[i + 1].above <= steps[i].above;
    if (is_new && !is_empty) steps[kept++] = {.above = steps[i].above, .acceleration = lowest};
  }
  return {steps, kept, mode.rules.whole_cycles};
}

/// Acceleration and jerks along a path.
struct Along {
  double acceleration = unlimited;
  double build_up = unlimited, take_back = unlimited;  ///< jerks
  double longest_build_up = 0, longest_take_back = 0;  ///< times

  void take(double a, double tr_build_up, double tr_take_back, double share) {
    acceleration = std::min(acceleration, a / share);
    build_up = std::min(build_up, a / tr_build_up / share);
    take_back = std::min(take_back, a / tr_take_back / share);
    longest_build_up = std::max(longest_build_up, tr_build_up);
    longest_take_back = std::max(longest_take_back, tr_take_back);
  }
  void take(AxisRamp const& ramp, double share) {
    take(ramp.acceleration, ramp.build_up, ramp.take_back, share);
  }
  [[nodiscard]] double build_up_time(machine::ProjectionReading reading) const {
    return reading == machine::ProjectionReading::weakest_jerk ? acceleration / build_up : longest_build_up;
  }
  [[nodiscard]] double take_back_time(machine::ProjectionReading reading) const {
    return reading == machine::ProjectionReading::weakest_jerk ? acceleration / take_back : longest_take_back;
  }
};

/// A limit of the path leaves the times of ramps as they are.
Ramp limited_jerk(Along const& along, BlockMode const& mode, Sense sense, double most) {
  double const build_up = along.build_up_time(mode.projection);
  double const take_back = along.take_back_time(mode.projection);
  bool const is_up = sense == Sense::up;
  return {{.acceleration = std::min(along.acceleration, most),
           .at_slow_end = is_up ? build_up : take_back,
           .at_fast_end = is_up ? take_back : build_up},
          mode.rules};
}

Ramp line_ramp(BlockMode const& mode, Point const& direction, Sense sense) {
  double const most = sense == Sense::up ? mode.vector_up : mode.vector_down;
  if (mode.slope == machine::Slope::step) return staircase(mode, direction, sense, most);
  Along along;
  for_each_moving(mode, direction,
                  [&](AxisMode const& axis, double share) { along.take(ramp_of(axis, sense), share); });
  return limited_jerk(along, mode, sense, most);
}

/// The two axes of an arc's plane.
struct Plane {
  BlockMode const& mode;
  Arc const& arc;
  AxisMode const& first = mode.axes[arc.first];
  AxisMode const& second = mode.axes[arc.second];

  /// Of the weaker axis, direction and stage.
  [[nodiscard]] double acceleration() const {
    if (mode.slope != machine::Slope::step) {
      return std::min(
          {first.up.acceleration, first.down.acceleration, second.up.acceleration, second.down.acceleration});
    }
    double lowest = unlimited;
    for (auto const* const axis : {&first, &second}) {
      for (auto const* const ramp : {&axis->up, &axis->down}) {
        lowest = std::min({lowest, ramp->first, ramp->second});
      }
    }
    return lowest;
  }
  /// √(a ρ / √2)
  [[nodiscard]] double bent_velocity() const {
    double const part = mode.circle == machine::CircleReading::shared ? std::numbers::sqrt2 : 1;
    return std::sqrt(std::min(acceleration() / part, mode.vector_radial) * arc.curvature_radius());
  }
  /// ∛(a ρ² / tr_geom)
  [[nodiscard]] double jerk_velocity() const {
    if (mode.slope == machine::Slope::step) return unlimited;
    double jerk = unlimited;
    for (auto const* const axis : {&first, &second}) {
      jerk = std::min(jerk, std::min(axis->up.acceleration, axis->down.acceleration) / axis->curve_ramp);
    }
    double const radius = arc.curvature_radius();
    return std::cbrt(jerk * radius * radius);
  }
  /// √(a² - (v² / ρ)²), of which the way across takes at most a / √2.
  [[nodiscard]] double along(double velocity) const {
    double const a = acceleration();
    if (mode.circle == machine::CircleReading::full) return a;
    double const across = std::min(velocity * velocity / arc.curvature_radius(), a / std::numbers::sqrt2);
    return std::sqrt(a * a - across * across);
  }
};

Ramp arc_ramp(Plane const& plane, Point const& aside, double velocity, Sense sense) {
  auto const& mode = plane.mode;
  double const share = plane.arc.share;
  double const a = plane.along(velocity);
  double limit = unlimited;
  if (mode.limits_circles) limit = sense == Sense::up ? mode.vector_up : mode.vector_down;
  if (mode.slope == machine::Slope::step) return staircase(mode, aside, sense, std::min(limit, a / share));
  Along in_plane;
  in_plane.take(ramp_of(plane.first, sense), 1);
  in_plane.take(ramp_of(plane.second, sense), 1);
  Along along;
  along.take(a, in_plane.build_up_time(mode.projection), in_plane.take_back_time(mode.projection), share);
  for_each_moving(mode, aside,
                  [&](AxisMode const& axis, double part) { along.take(ramp_of(axis, sense), part); });
  return limited_jerk(along, mode, sense, limit);
}

void lower(PathBlock& block, double velocity, LimitedBy cause) {
  if (velocity >= block.velocity_within) return;
  block.velocity_within = velocity;
  block.velocity_cause = cause;
}

}  // namespace

void PathLimits::set_acceleration_factor(double factor) {
  if (std::exchange(acceleration_factor_, factor) != factor) feed_ = rapid_ = {};
}

std::shared_ptr<BlockMode const> PathLimits::mode_of(ProgrammedBlock const& block) {
  auto& known = block.rapid ? rapid_ : feed_;
  if (!known.mode || known.words != block.dynamics) {
    known.words = block.dynamics;
    known.mode = std::make_shared<BlockMode const>(
        block_mode(dynamics_, block.dynamics.get(), block.rapid, acceleration_factor_));
  }
  return known.mode;
}

PathBlock PathLimits::block(ProgrammedBlock const& asked, Point const& position, double length, double most,
                            bool begins_faster) {
  PathBlock block;
  block.end = asked.end;
  block.length = length;
  block.mode = mode_of(asked);
  block.rapid = asked.rapid;
  block.brakes_late = asked.brakes_late;
  block.line = asked.line;
  block.label = asked.label;
  auto const& mode = *block.mode;
  Point way = minus(asked.end, position);
  if (asked.arc) way[asked.arc->first] = way[asked.arc->second] = 0;
  auto const direction = plus({}, 1 / length, way);
  block.velocity_within = mode.vector_velocity;
  lower(block, highest_velocity(mode, direction), LimitedBy::axis);
  lower(block, most, LimitedBy::tolerance);
  if (asked.arc) {
    block.path = Segment(position, direction, asked.arc);
    Plane const plane{.mode = mode, .arc = *asked.arc};
    double const in_plane = std::min(plane.first.velocity, plane.second.velocity) / asked.arc->share;
    lower(block, in_plane, LimitedBy::axis);
    if (mode.limits_curves) lower(block, plane.bent_velocity(), LimitedBy::curve);
    lower(block, plane.jerk_velocity(), LimitedBy::curve_jerk);
  } else {
    block.path = Segment(position, direction);
  }
  block.velocity = block.velocity_within;
  if (asked.feed <= block.velocity) {
    block.velocity = asked.feed;
    block.velocity_cause = LimitedBy::feed;
  }
  if (asked.arc) {
    Plane const plane{.mode = mode, .arc = *asked.arc};
    double const fastest = begins_faster ? block.velocity_within : block.velocity;
    block.up = arc_ramp(plane, direction, fastest, Sense::up);
    block.down = arc_ramp(plane, direction, fastest, Sense::down);
  } else {
    block.up = line_ramp(mode, direction, Sense::up);
    block.down = line_ramp(mode, direction, Sense::down);
  }
  return block;
}

}  // namespace axisc::motion
