// How much a resonance swings after the planner's ramps have passed a chain: from rest to a velocity, and,
// after a travel so long that nothing is left of it, back to rest. The larger of both counts.
//
// A mass on a spring rides on the axis,  x'' + 2 D ω x' + ω² x = -s'',  x its position relative to the axis.
// Setpoints are joined by straight lines: in each cycle the velocity jumps by  a[n] = s[n+1] - 2 s[n] +
// s[n-1],  and with p = e^((-D ω + j ω_d) T)  the oscillation is
//     q[n] = p q[n-1] + a[n],  |x| ≤ |q| / (ω_d T).
// It counts from the moment at which the axis would rest if the chain were symmetrical: twice its delay after
// the ramp. A chain that is not done then pays for what follows.
#pragma once

#include "analysis/tuning/suggestion/impulse_response.hpp"
#include "analysis/tuning/suggestion/largest_swing.hpp"
#include "analysis/tuning/suggestion/task.hpp"

#include <complex>
#include <cstddef>
#include <vector>

namespace axisc::tuning {

/// Where a resonance is looked for, as shares of its frequency, and the damping ratios it may have.
inline constexpr double frequency_tolerance = 0.1;
inline constexpr double lowest_damping = 0.02;
inline constexpr double highest_damping = 0.2;
inline constexpr double negligible_vibration = 1e-6;

struct Vibration {
  /// Largest amplitude over the frequencies within frequency_tolerance, or twice the uncertainty where that
  /// is more, and over lowest_damping to highest_damping, as a share of the largest without filters. Too
  /// small by at most a 10,000th of itself and negligible_vibration.
  double worst = 1;
  double amplitude = 0;   ///< at the frequency itself with the known damping, else the lowest; position units
  double unfiltered = 0;  ///< the same without filters
};

class Excitation {
 public:
  explicit Excitation(Task const& task);

  /// One for each resonance of the task. Cost: some 30 passes over the taps for each resonance.
  [[nodiscard]] std::vector<Vibration> after(ImpulseResponse const& chain) const;
  /// The largest `worst` is at least this. Cost: a 10th.
  [[nodiscard]] double at_least_after(ImpulseResponse const& chain) const;
  /// What a chain leaves of an impulse right after its last tap, at places in the bands of the resonances:
  ///     Σ b[k] p^(N - 1 - k)
  /// Those of chains in series multiply.
  [[nodiscard]] std::vector<std::complex<double>> ringing(ImpulseResponse const& chain) const;
  /// at_least_after() of a chain with this ringing, taps and delay is at least this.
  [[nodiscard]] double at_least_ringing(std::vector<std::complex<double>> const& ringing, std::size_t taps,
                                        double delay) const;
  /// These ramps without filters in the place of other ones: shares are those of what `present` leaves
  /// without filters. For the same resonances.
  [[nodiscard]] std::vector<Vibration> beside(Excitation const& present) const;

 private:
  struct Swinging {
    SwingBand band;
    double frequency = 0, damping = 0;                ///< of the resonance itself; rad per cycle
    double unfiltered_worst = 0, unfiltered_own = 0;  ///< swings
  };

  /// A frequency with the least damping: p, and the shares of STEP's worst case that an oscillation q[n] is.
  struct Place {
    std::complex<double> p;
    double share = 0;                         ///< of |q|
    std::vector<std::complex<double>> ramps;  ///< what each ramp leaves right after its last jump
  };
  static constexpr int places_of_band = 5;

  void add_places(Swinging const& one);
  [[nodiscard]] std::vector<Drive> drives_behind(ImpulseResponse const& chain) const;

  std::vector<std::vector<double>> ramps_;  ///< a[n] of the unfiltered setpoint; up, and down if that differs
  std::vector<Swinging> resonances_;
  std::vector<Place> places_;
};

}  // namespace axisc::tuning
