// How fast a path may be driven: what the lists of axes and channels say about velocity, acceleration and
// jerk. Units are those of the lists; every cap that a list sets on its own values is already applied.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace axisc::machine {

/// How the acceleration comes and goes (#SLOPE). Values are the numbers of P-CHAN-00071.
enum class Slope : std::uint8_t { step = 0, trapez = 1, sin2 = 2, hsc = 3 };

/// As #SLOPE names them, by number.
inline constexpr std::array<std::string_view, 4> slope_names{"STEP", "TRAPEZ", "SIN2", "HSC"};

[[nodiscard]] constexpr std::optional<Slope> slope_named(std::string_view name) {
  for (std::size_t i = 0; i < slope_names.size(); ++i) {
    if (slope_names[i] == name) return static_cast<Slope>(i);
  }
  return std::nullopt;
}

/// The acceleration of the slope STEP: the second stage counts above the changeover velocity.
struct AccelerationStages {
  double first = 1000, second = 1000;  ///< mm/s² or °/s²
  double changeover = 100000;          ///< µm/s or 1e-3 °/s
};

/// The acceleration of the other slopes, and the times in which it is built up and taken back.
struct AccelerationRamp {
  double acceleration = 1000;                  ///< mm/s² or °/s²
  double build_up = 50000, take_back = 50000;  ///< µs
};

/// An axis in feed blocks (G01 to G03), or in rapid blocks (G00).
struct MotionDynamics {
  double velocity = 200000;  ///< µm/s or 1e-3 °/s
  AccelerationStages step_up, step_down;
  AccelerationRamp up, down;
};

struct AxisDynamics {
  MotionDynamics feed;
  MotionDynamics rapid = {.velocity = 166666,
                          .step_up = {},
                          .step_down = {},
                          .up = {.build_up = 10000, .take_back = 10000},
                          .down = {.build_up = 10000, .take_back = 10000}};
  double curve_ramp_time = 10000;               ///< P-AXIS-00199, µs
  double highest_acceleration = 1000;           ///< P-AXIS-00008
  double shortest_ramp_time = 10000;            ///< P-AXIS-00201, µs
  std::optional<double> weighted_acceleration;  ///< P-AXIS-00292: most that a weight above 100 % gives
  double shortest_weighted_ramp_time = 0;       ///< P-AXIS-00293, µs
  double acceleration_transition_weight = 0;    ///< P-AXIS-00013, 0.1 %
  double curvature_transition_weight = 1000;    ///< P-AXIS-00154, 0.1 %
  double corner_jerk = 0, curvature_jerk = 0;   ///< P-AXIS-00339, 00340, m/s³ or 1000 °/s³
  double exact_stop_window = 500;               ///< P-AXIS-00236, 0.1 µm or 1e-4 °
};

/// Path limits of `#VECTOR LIMIT`, where the command gives none.
struct VectorLimits {
  double velocity = 2e9;                                                     ///< mm/min
  double acceleration = 1e8, deceleration = 1e8, radial_acceleration = 1e8;  ///< see `per_minute`
  bool per_minute = true;       ///< P-CHAN-00351: mm/min², otherwise mm/s²
  bool limits_circles = false;  ///< P-CHAN-00350
};

struct ChannelDynamics {
  Slope slope = Slope::step;               ///< P-CHAN-00071
  bool constant_ramp_times = false;        ///< P-CHAN-00349
  std::uint8_t weighted_acceleration = 0;  ///< P-CHAN-00001: 0 all, 1 up, 2 down
  std::uint8_t weighted_ramp = 0;         ///< P-CHAN-00073: 0 all, 1 to 4 up and down, build up and take back
  bool limits_curvature_steps = false;    ///< P-CHAN-00009
  std::uint8_t transition_mode = 0;       ///< P-CHAN-00117
  std::uint32_t look_ahead_blocks = 120;  ///< P-CHAN-00650, 00653
  bool stops_after_rapid = false;         ///< P-CHAN-00235
  VectorLimits vector;
  bool is_from_list = false;  ///< a channel list sets values; otherwise the defaults count
};

// What the manual leaves open (readings), the first of each as default.
enum class ProjectionReading : std::uint8_t { weakest_jerk, longest_ramp };
enum class BorderReading : std::uint8_t { rest, continuous };
enum class SineReading : std::uint8_t { ramps, whole_change, same_peak_jerk };
enum class CircleReading : std::uint8_t { shared, full };
enum class CornerReading : std::uint8_t { per_cycle, up_only, down_only };
enum class TransitionReading : std::uint8_t { r_follows_a, a_follows_r };
enum class CycleReading : std::uint8_t { continuous, whole };
enum class HscReading : std::uint8_t { stretches, trapez };

struct MotionReadings {
  ProjectionReading projection = {};
  BorderReading borders = {};
  SineReading sine = {};
  CircleReading circle = {};
  CornerReading corner = {};
  TransitionReading weights = {};
  CycleReading cycles = {};
  HscReading hsc = {};
};

}  // namespace axisc::machine
