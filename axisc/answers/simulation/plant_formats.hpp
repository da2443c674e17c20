// Results of `axisc simulate --plant`, and their output formats.
#pragma once

#include "analysis/motion/closed_loop.hpp"
#include "analysis/motion/spectrum.hpp"
#include "diagnostics/message.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

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
  double distance_mm = 0, feed_mm_per_min = 0, kv = 0;
  bool has_function = false;
  std::vector<PhaseOscillation> oscillations;  ///< none without function: there is nothing to compare
  double largest_additive = 0;                 ///< µm/s
  double limit = 0;                            ///< µm/s
  bool limit_hit = false;
  bool diverges_without = false, diverges_with = false;
  std::optional<double> highest_kv_without, highest_kv_with;  ///< 1/s; see motion::highest_kv
};

[[nodiscard]] std::string plant_text(ClosedLoopFigures const& figures, Language language);
[[nodiscard]] std::string plant_json(ClosedLoopFigures const& figures);
/// The two records, cycle by cycle, as CSV.
[[nodiscard]] std::string plant_csv(motion::LoopRecord const& without, motion::LoopRecord const& with,
                                    double cycle_seconds);

}  // namespace axisc
