#include "analysis/motion/planning/axis_mode.hpp"

#include <algorithm>
#include <numbers>

namespace axisc::motion {
namespace {

using machine::AxisDynamics;
using machine::Slope;

constexpr double percent = 100;
constexpr double full_weight = 1000;  // of 0.1 %
constexpr double jerk_unit = 1000;    // m/s³ in mm/s³

/// The lists' units per cycle.
struct Units {
  double T;

  /// µm/s
  [[nodiscard]] double velocity(double value) const { return value * units_per_um * T; }
  /// mm/s²
  [[nodiscard]] double acceleration(double value) const { return value * units_per_mm * T * T; }
  /// µs
  [[nodiscard]] double time(double value) const { return value * 1e-6 / T; }
};

double weighted_acceleration(double value, double weight, AxisDynamics const& axis) {
  double const wanted = value * weight / percent;
  if (weight <= percent) return wanted;
  double const cap = axis.weighted_acceleration.value_or(axis.highest_acceleration);
  return std::min(wanted, std::max(value, cap));
}

double weighted_time(double value, double weight, AxisDynamics const& axis) {
  double const wanted = value * weight / percent;
  if (weight >= percent) return wanted;
  return std::max(wanted, std::min(value, axis.shortest_weighted_ramp_time));
}

double weighted_velocity(double value, double weight, AxisDynamics const& axis) {
  constexpr double slowest = 1;
  if (weight <= 0) return slowest;
  return std::min(value * weight / percent, std::max(value, axis.feed.velocity));
}

AxisRamp axis_ramp(machine::AccelerationStages const& stages, machine::AccelerationRamp const& ramp,
                   RampWeights const& weights, AxisDynamics const& axis, Units units) {
  auto const acceleration = [&](double value) {
    return units.acceleration(weighted_acceleration(value, weights.acceleration, axis));
  };
  return {.first = acceleration(stages.first),
          .second = acceleration(stages.second),
          .changeover = units.velocity(stages.changeover),
          .acceleration = acceleration(ramp.acceleration),
          .build_up = units.time(weighted_time(ramp.build_up, weights.build_up, axis)),
          .take_back = units.time(weighted_time(ramp.take_back, weights.take_back, axis))};
}

double longest_time(AxisMode const& mode) {
  return std::max({mode.up.build_up, mode.up.take_back, mode.down.build_up, mode.down.take_back});
}

/// A weight w as a share: w a T is the largest step of the velocity, w' a that of the acceleration. Without a
/// weight a step is what the jerk does in a cycle, T/tr.
void set_steps(AxisMode& mode, AxisDynamics const& axis, PathDynamics const& path, double factor) {
  double const a = std::min(mode.up.acceleration, mode.down.acceleration);
  double const longest = longest_time(mode);
  double const of_jerk = longest > 1 ? 1 / longest : 1;
  bool const by_jerk = path.channel.transition_mode == 2;
  double const T = path.cycle_time.seconds();
  double const per_jerk = jerk_unit * units_per_mm * T * T * T;
  double corner = axis.acceleration_transition_weight / full_weight * factor;
  double curve = axis.curvature_transition_weight / full_weight;
  if (by_jerk) {
    corner = std::min(1.0, axis.corner_jerk * per_jerk / a);
    curve = std::min(1.0, axis.curvature_jerk * per_jerk / a);
  }
  if (!(corner > 0)) corner = of_jerk;
  if (!(curve > 0)) curve = of_jerk;
  if (path.channel.transition_mode == 0) {
    bool const r_follows = path.readings.weights == machine::TransitionReading::r_follows_a;
    (r_follows ? curve : corner) = std::max(corner, curve);
  }
  mode.corner_step = corner * a;
  mode.curve_step = curve * a;
}

AxisMode axis_mode(AxisDynamics const& axis, AxisWeights const& weights, bool rapid, Slope slope,
                   PathDynamics const& path, double factor) {
  Units const units{path.cycle_time.seconds()};
  auto const& motion = rapid ? axis.rapid : axis.feed;
  AxisMode mode;
  mode.velocity = units.velocity(weighted_velocity(motion.velocity, weights.velocity, axis));
  mode.up = axis_ramp(motion.step_up, motion.up, weights.up, axis, units);
  mode.down = axis_ramp(motion.step_down, motion.down, weights.down, axis, units);
  mode.curve_ramp = units.time(weighted_time(axis.curve_ramp_time, weights.curve_ramp, axis));
  if (slope == Slope::hsc) {
    double const longest = longest_time(mode);
    mode.up.build_up = mode.up.take_back = mode.down.build_up = mode.down.take_back = longest;
  }
  set_steps(mode, axis, path, factor);
  bool const same_jerk = slope == Slope::sin2 && path.readings.sine == machine::SineReading::same_peak_jerk;
  if (same_jerk) {
    // The largest jerk of p sin²(πt/2T) is π/2 p/T.
    for (auto* const ramp : {&mode.up, &mode.down}) {
      ramp->build_up *= std::numbers::pi / 2;
      ramp->take_back *= std::numbers::pi / 2;
    }
  }
  return mode;
}

}  // namespace

BlockMode block_mode(PathDynamics const& dynamics, BlockDynamics const* words, bool rapid,
                     double acceleration_factor) {
  static BlockDynamics const unsaid;
  auto const& said = words != nullptr ? *words : unsaid;
  Units const units{dynamics.cycle_time.seconds()};
  auto const& readings = dynamics.readings;
  BlockMode mode;
  mode.slope = words != nullptr ? said.slope : dynamics.channel.slope;
  bool const constant_times =
      words != nullptr ? said.constant_ramp_times : dynamics.channel.constant_ramp_times;
  bool const has_borders = mode.slope == Slope::trapez || mode.slope == Slope::sin2;
  mode.rules = {
      .sine = mode.slope == Slope::sin2,
      .constant_times = constant_times && has_borders && !rapid,
      .whole_change = mode.slope == Slope::sin2 && readings.sine == machine::SineReading::whole_change,
      .whole_cycles = readings.cycles == machine::CycleReading::whole};
  mode.across_blocks = (mode.slope == Slope::hsc && readings.hsc == machine::HscReading::stretches) ||
                       (has_borders && readings.borders == machine::BorderReading::continuous);
  mode.limits_corners = said.limits_corners;
  mode.limits_curves = said.limits_curves;
  mode.limits_curvature_steps = dynamics.channel.limits_curvature_steps && mode.slope != Slope::step;
  mode.projection = readings.projection;
  mode.circle = readings.circle;
  mode.corner = readings.corner;
  mode.vector_velocity = units.velocity(said.vector.velocity * um_per_mm);
  mode.vector_up = units.acceleration(said.vector.acceleration);
  mode.vector_down = units.acceleration(said.vector.deceleration);
  mode.vector_radial = units.acceleration(said.vector.radial_acceleration);
  mode.limits_circles = dynamics.channel.vector.limits_circles;
  mode.least_corner_velocity = units.velocity(said.least_corner_velocity.value_or(0) * um_per_mm);
  mode.axis_count = dynamics.axes.size();
  for (std::size_t i = 0; i < dynamics.axes.size(); ++i) {
    double const weight = dynamics.axes[i].acceleration_transition_weight > 0 ? acceleration_factor : 1;
    mode.axes[i] =
        axis_mode(dynamics.axes[i], (rapid ? said.rapid : said.feed)[i], rapid, mode.slope, dynamics, weight);
  }
  return mode;
}

}  // namespace axisc::motion
