// An axis in its position loop: there, a rest, back, a rest. Setpoints pass the image's filters, measured
// velocities its stages of Improved Position Control; both are executed by the runtime.
//
//     v_set = Kv (x_set - x) + f x_set',   v = v_set + v_add
#pragma once

#include "analysis/motion/path_block.hpp"
#include "analysis/motion/plant.hpp"
#include "image/runtime_host.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::motion {

/// A move of one axis, planned as a feed block (G01); position units and cycles.
struct AxisMove {
  std::size_t axis = 0;        ///< of the image
  double distance = 0;         ///< position units, its sign the direction
  double velocity = 0;         ///< units per cycle
  PathDynamics dynamics = {};  ///< of the axis alone, with the slope of its channel
};

enum class MovePhase : std::uint8_t { ramp, travel, rest };

struct LoopCycle {
  MovePhase phase = MovePhase::rest;
  bool back = false;
  double setpoint = 0;           ///< position units
  double load_position = 0;      ///< position units
  double load_acceleration = 0;  ///< m/s²
  double set_velocity = 0;       ///< µm/s, v_set
  double motor_velocity = 0;     ///< µm/s
  double load_velocity = 0;      ///< µm/s
  double additive_velocity = 0;  ///< µm/s
};

struct LoopRecord {
  std::vector<LoopCycle> cycles;
  bool lost = false;  ///< ended early: the plant left every bound
};

/// Seconds that the axis rests after each motion.
inline constexpr double rest_seconds = 1.5;

/// `with_function`: the additive velocity acts; else it is only calculated. The runtime is reset first.
[[nodiscard]] LoopRecord simulate_loop(image::RuntimeHost& runtime, AxisMove const& move,
                                       PlantParameters const& plant, bool with_function);

/// The load's acceleration in one phase, there or back. For a rest only the first third counts: the
/// oscillation left by braking.
[[nodiscard]] std::vector<double> load_accelerations(LoopRecord const& record, MovePhase phase, bool back);

/// The oscillation outlives the motion: the load's acceleration does not die down after it, or the plant was
/// lost.
[[nodiscard]] bool diverges(LoopRecord const& record, double cycle_seconds);

/// Kv in 1/s beyond which no loop is tried.
inline constexpr double kv_search_end = 1000;

/// The largest Kv from 1 to kv_search_end at which the loop does not diverge, within 1 %; 0 where it already
/// diverges at 1. None where it does not diverge at the end of the search.
[[nodiscard]] std::optional<double> highest_kv(image::RuntimeHost& runtime, AxisMove const& move,
                                               PlantParameters plant, bool with_function);

}  // namespace axisc::motion
