// Which stages of Improved Position Control damp the resonances of an axis best.
//
// One stage for each resonance, one after the other in their order, as a control is commissioned: all
// settings of stage_settings.hpp next to the stages chosen already, weights rising until the load swings more
// and more after the stop. A share is what is left of a resonance: its worst case over the plants with the
// function, divided by the worst case without. Settings count
//  - that take away a quarter of the resonance with the plant itself,
//  - that move the load on the task's circle by no more than the tolerance,
//  - and keep stable with each plant, also with twice the weights (or 7, which the control allows at most).
// Of those under which the sum of shares falls by half a share or more, the one that moves the load least
// wins; where there is none, or the task wants the least vibration, the one with the smallest sum.
//
// The winner has then been simulated as a whole, with teeth, limit and the rest after the move:
// motion::simulate_loop.
#pragma once

#include "analysis/tuning/position_control/loop_task.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace axisc::tuning {

/// A stage has to take at least this share of the vibration away.
inline constexpr double useful_share = 0.25;
/// m/s²: a smaller vibration needs no damping.
inline constexpr double noticeable_swing = 0.02;
/// More than this is not worth a larger shift of the load.
inline constexpr double sufficient_share = 0.5;

struct DampedResonance {
  bool is_in_plant = true;                  ///< else it has no stage
  bool is_noticeable = true;                ///< else neither
  std::optional<std::uint32_t> stage = {};  ///< of the control
  double without = 0, with = 0;             ///< m/s², the plant itself
  double worst_without = 0, worst = 0;      ///< m/s², over plants_of()
};

struct Damping {
  machine::PositionControl control;
  std::vector<DampedResonance> resonances;
  double additive_velocity = 0;  ///< largest, µm/s, the plant itself
  /// Largest distance of the load from where it is without function: by this much is the axis out of step
  /// with axes without it.
  double shift = 0;                          ///< in the move, position units
  double circle = 0;                         ///< on the task's circle, position units
  double error_without = 0, error_with = 0;  ///< largest distance of the load from the setpoint
  std::size_t looked_at = 0;
};

enum class NoDamping : std::uint8_t {
  diverges,      ///< the loop oscillates without any function, or with a plant of other frequencies does
  no_resonance,  ///< the plant has none of them
  still,         ///< the load hardly swings in the move: less than noticeable_swing
  not_enough     ///< no stage takes away enough and keeps its margin
};

struct NoDampingFound {
  NoDamping reason = NoDamping::not_enough;
  std::size_t looked_at = 0;
};

[[nodiscard]] std::variant<Damping, NoDampingFound> damp(LoopTask const& task);

}  // namespace axisc::tuning
