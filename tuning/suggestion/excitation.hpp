// How much a resonance swings after the planner's ramp from rest to a velocity has passed a chain.
//
// A mass on a spring rides on the axis,  x'' + 2 D ω x' + ω² x = -s'',  x its position relative to the axis. Setpoints are
// joined by straight lines: in each cycle the velocity jumps by  a[n] = s[n+1] - 2 s[n] + s[n-1],  and with
// p = e^((-D ω + j ω_d) T)  the oscillation is
//     q[n] = p q[n-1] + a[n],  |x| ≤ |q| / (ω_d T).
// It counts from the moment at which the axis would rest if the chain were symmetrical: twice its delay after the ramp. A
// chain that is not done then pays for what follows.
#pragma once

#include "tuning/suggestion/impulse_response.hpp"
#include "tuning/suggestion/task.hpp"

#include <cstddef>
#include <vector>

namespace axisc::tuning {

/// Where a resonance is looked for, as shares of its frequency, and the damping ratios it may have.
inline constexpr double frequency_tolerance = 0.1;
inline constexpr double lowest_damping = 0.02;
inline constexpr double highest_damping = 0.2;

struct Vibration {
  /// Largest amplitude over the frequencies within frequency_tolerance, or twice the uncertainty where that is more, and over
  /// lowest_damping to highest_damping, as a share of the largest without filters.
  double worst = 1;
  double amplitude = 0;   ///< at the frequency itself with the known damping, else the lowest; position units
  double unfiltered = 0;  ///< the same without filters
};

class Excitation {
 public:
  explicit Excitation(Task const& task);

  /// One for each resonance of the task. Cost: some ns for each tap, resonance and damping.
  [[nodiscard]] std::vector<Vibration> after(ImpulseResponse const& chain) const;

 private:
  [[nodiscard]] std::vector<double> amplitudes(ImpulseResponse const& chain) const;

  std::vector<double> ramp_;           ///< a[n] of the unfiltered setpoint
  std::vector<double> cosine_, sine_;  ///< p: for each resonance the grid, then the resonance itself
  std::vector<double> scale_;          ///< 1 / (ω_d T)
  std::vector<double> unfiltered_;
};

}  // namespace axisc::tuning
