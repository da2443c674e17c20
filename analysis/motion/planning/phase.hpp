// A phase of a motion along a path: constant velocity, constant acceleration, constant jerk, or an
// acceleration that rises or falls like sin².
//
// With constant jerk,
//     v = v0 + a t + j t²/2,  s = v0 t + a t²/2 + j t³/6.
// A rise to the peak p in the time T, a = p sin²(πt/2T), gives
//     v = v0 + p (t/2 - T/2π sin(πt/T)),  s = v0 t + p (t²/4 - T²/2π² (1 - cos(πt/T))),
// a fall a = p cos²(πt/2T) the same with the opposite sign before T.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace axisc::motion {

/// Cycles: rounding of the times of phases.
inline constexpr double same_time = 1e-9;

enum class PhaseShape : std::uint8_t { constant_jerk, sine_rise, sine_fall };

/// Units are position units and cycles.
struct Phase {
  double duration = 0;
  double length = 0;
  double velocity = 0;      ///< at its beginning
  double acceleration = 0;  ///< at its beginning; of a sine the peak
  double jerk = 0;          ///< constant; of a sine 0
  double sine_time = 0;     ///< T
  double sine_begun = 0;    ///< how much of T is over before this phase begins
  PhaseShape shape = PhaseShape::constant_jerk;

  [[nodiscard]] bool is_steady() const {
    return shape == PhaseShape::constant_jerk && acceleration == 0 && jerk == 0;
  }
  /// So long after its beginning.
  [[nodiscard]] double velocity_at(double t) const {
    return std::max(0.0, velocity + (shape == PhaseShape::constant_jerk
                                         ? t * (acceleration + t * jerk / 2)
                                         : acceleration * (gained(sine_begun + t) - gained(sine_begun))));
  }
  [[nodiscard]] double way_at(double t) const {
    if (shape == PhaseShape::constant_jerk) {
      return std::min(length, t * (velocity + t * (acceleration / 2 + t * jerk / 6)));
    }
    double const passed_since = passed(sine_begun + t) - passed(sine_begun) - gained(sine_begun) * t;
    return std::min(length, velocity * t + acceleration * passed_since);
  }
  [[nodiscard]] double acceleration_at(double t) const {
    if (shape == PhaseShape::constant_jerk) return acceleration + jerk * t;
    double const angle = std::numbers::pi * (sine_begun + t) / (2 * sine_time);
    double const root = shape == PhaseShape::sine_rise ? std::sin(angle) : std::cos(angle);
    return acceleration * root * root;
  }
  [[nodiscard]] double jerk_at(double t) const {
    if (shape == PhaseShape::constant_jerk) return jerk;
    double const angle = std::numbers::pi * (sine_begun + t) / sine_time;
    double const change = acceleration * std::numbers::pi / (2 * sine_time) * std::sin(angle);
    return shape == PhaseShape::sine_rise ? change : -change;
  }
  [[nodiscard]] double velocity_out() const { return velocity_at(duration); }

  /// Along a way at one velocity.
  [[nodiscard]] static Phase steady(double velocity, double length) {
    Phase phase;
    phase.velocity = velocity;
    phase.length = length;
    phase.duration = length / velocity;
    return phase;
  }

 private:
  /// Of the peak's velocity and way.
  [[nodiscard]] double gained(double t) const {
    double const wave = sine_time / (2 * std::numbers::pi) * std::sin(std::numbers::pi * t / sine_time);
    return t / 2 + (shape == PhaseShape::sine_rise ? -wave : wave);
  }
  [[nodiscard]] double passed(double t) const {
    double const wave = sine_time * sine_time / (2 * std::numbers::pi * std::numbers::pi) *
                        (1 - std::cos(std::numbers::pi * t / sine_time));
    return t * t / 4 + (shape == PhaseShape::sine_rise ? -wave : wave);
  }
};

}  // namespace axisc::motion
