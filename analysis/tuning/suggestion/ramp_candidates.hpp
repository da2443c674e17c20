// Ramp times instead of filters: with limited jerk a ramp leaves nothing of an undamped resonance whose
// frequency is a zero of its envelope (ramp_envelope.hpp):
//     TRAPEZ and HSC  tr = n / f,    sin²  tr = (n + 1/2) / f,   n = 1, 2, …
// All four ramps of an axis get the same time. A contour stays as it is, and no setpoint is delayed; what it
// costs is time, in each change of velocity.
#pragma once

#include "analysis/tuning/suggestion/excitation.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::tuning {

/// The zeros of each resonance that are tried.
inline constexpr int most_zeros = 3;

struct RampCandidate {
  std::uint32_t ramp_time = 0;  ///< µs
  std::size_t resonance = 0;    ///< of the task, whose zero it is
  int zero = 1;                 ///< n
  double vibration = 1;         ///< the worst of the resonances, as a share of that of the present ramps
  std::vector<Vibration> resonances = {};
  double up_time = 0, down_time = 0;  ///< from rest to the velocity, and back; cycles
};

struct RampCandidates {
  std::vector<RampCandidate> candidates = {};  ///< by ramp time; none shorter than P-AXIS-00201 allows
  double up_time = 0, down_time = 0;           ///< of the present ramps, cycles
  /// The quickest that leaves enough of the vibration away: see sufficient_vibration.
  std::optional<std::size_t> quickest = {};
};

/// None with STEP, which no ramp time acts on. `present`: of the task.
[[nodiscard]] std::optional<RampCandidates> ramp_candidates(Task const& task, Excitation const& present);

}  // namespace axisc::tuning
