// An axis in its closed loop, there and back, with and without Improved Position Control.
#pragma once

#include "analysis/motion/closed_loop.hpp"
#include "analysis/motion/spectrum.hpp"
#include "axisc/checking/path_machine.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axisc {

struct PlantRequest {
  std::string machine_path;
  std::string plant_path;
  std::string move;  ///< AXIS:MM or AXIS:MM:MM_PER_MIN
};

/// The load's dominant oscillation in one phase of the move.
struct PhaseOscillation {
  motion::MovePhase phase = motion::MovePhase::travel;
  motion::Oscillation without;
  /// Amplitude with the function, m/s²: the same frequency in the same window. None where the loop was lost
  /// before.
  std::optional<double> with;
};

struct ClosedLoopFigures {
  std::string axis;
  machine::ChannelDynamics channel;  ///< whose slope the axis moves with
  double distance_mm = 0, feed_mm_per_min = 0, kv = 0;
  bool has_function = false;
  std::vector<PhaseOscillation> oscillations;  ///< none without function: there is nothing to compare
  double largest_additive = 0;                 ///< µm/s
  double limit = 0;                            ///< µm/s
  bool limit_hit = false;
  bool diverges_without = false, diverges_with = false;
  std::optional<double> highest_kv_without, highest_kv_with;  ///< 1/s; see motion::highest_kv
};

/// What a move gave, without and with the function.
struct PlantRun {
  ClosedLoopFigures figures;
  motion::LoopRecord without, with;
  double cycle_seconds = 0;
};

/// `searches_kv`: also finds the highest Kv, which takes most of the time. Failure for a move or a plant file
/// that cannot be used.
[[nodiscard]] PlantRun run_plant(PlantRequest const& request, CheckedMachine const& checked,
                                 bool searches_kv);

/// The band of frequencies in which oscillations are looked for, in Hz.
[[nodiscard]] std::pair<double, double> oscillation_band(double cycle_seconds);

}  // namespace axisc
