// Lines in the spectrum of motion at constant speed: what keeps its frequency at every speed, and what moves
// with it.
//
// Ripple of the torque, teeth and balls excite a resonance at every speed, where its frequency stays; what
// comes once a turn or a pitch is proportional to the speed.
#pragma once

#include "analysis/tuning/identification/motion_pieces.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace axisc::tuning {

enum class LineKind : std::uint8_t {
  constant,      ///< a resonance
  proportional,  ///< to the speed: `distance`
  mains,         ///< a multiple of 50 or 60 Hz
  at_rest,       ///< it goes on while the axis rests: something else shakes it
  ambiguous,     ///< at each speed another multiple of a proportional one
};

struct SpectralLine {
  LineKind kind = LineKind::constant;
  double frequency = 0;              ///< Hz; of a proportional one at the lowest speed
  double frequency_uncertainty = 0;  ///< standard error over the pieces, at least 0.5 %
  double amplitude = 0;              ///< mean over the pieces, in the unit of the signal
  double distance = 0;  ///< units of the setpoint from one time to the next, of proportional ones
};

enum class LinesDoubt : std::uint8_t {
  few_pieces,  ///< at constant speed
  one_speed,   ///< what keeps its frequency cannot be told from what moves with the speed
  no_lines,    ///< none that keeps its frequency
};

struct SpectralLines {
  std::vector<SpectralLine> lines;   ///< those of one kind by rising frequency
  std::optional<LinesDoubt> doubt;   ///< present where no line is constant
  bool were_rests_compared = false;  ///< a rest was long enough to show what goes on there
};

/// Searches between two frequencies, by the thresholds of thresholds.hpp.
[[nodiscard]] SpectralLines spectral_lines(std::span<SteadySignal const> pieces,
                                           std::span<SteadySignal const> rests, double lowest,
                                           double highest);

}  // namespace axisc::tuning
