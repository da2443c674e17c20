// Many settings of Improved Position Control tried in one loop.
//
// Apart from the teeth, the loop is linear: what an additive velocity adds to the motion is the same whatever
// else moves. So the move is simulated once without function, and for each setting only what the function
// adds, on a plant without teeth:
//     v = -Kv x + v_add,   v_add = stages(velocities of the move + velocities of what is added).
// The runtime executes the stages. The limit of the additive velocity (P-AXIS-00757) does not act here.
#pragma once

#include "analysis/tuning/position_control/loop_task.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::tuning {

struct Trial {
  /// After the stop the load swings more towards the end of the half second than in its middle; swings are
  /// not computed then.
  bool grows = false;
  std::vector<double> swings;  ///< m/s², by resonance
  double shift = 0;  ///< largest distance of the load from where it is without function, position units
};

class LoopTrials {
 public:
  /// One of the task's plants.
  LoopTrials(LoopTask const& task, motion::PlantParameters const& plant);

  /// The oscillation is there without any function.
  [[nodiscard]] bool diverges() const { return diverges_; }
  /// Without function.
  [[nodiscard]] std::vector<double> const& swings() const { return swings_; }

  /// Cost: some 100 µs for each second of the move and each setting.
  [[nodiscard]] std::vector<Trial> with(std::span<machine::PositionControl const> controls) const;

 private:
  [[nodiscard]] std::vector<double> swings_of(std::span<double const> accelerations) const;

  LoopTask const& task_;
  motion::PlantParameters plant_;          ///< without teeth
  std::vector<motion::LoopCycle> cycles_;  ///< there, and the first half second at rest
  std::size_t travel_begin_ = 0, travel_end_ = 0, rest_begin_ = 0;
  bool diverges_ = false;
  std::vector<double> swings_;
};

/// The runtime of the axis alone, with these stages.
[[nodiscard]] image::RuntimeHost loop_runtime(LoopTask const& task, machine::PositionControl const& control);

}  // namespace axisc::tuning
