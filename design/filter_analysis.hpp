// What a chain of designed filters does: frequency response, overshoot, peak gain, settling.
#pragma once

#include "design/filter_design.hpp"

#include <complex>
#include <cstdint>
#include <optional>
#include <span>

namespace axisc::design {

/// Complex response of one filter, share included, at `frequency`. Accurate to about 1e-13 also next to 0 Hz.
[[nodiscard]] std::complex<double> response(FilterDesign const& filter, Hertz frequency,
                                            CycleTime cycle_time);

struct ResponsePoint {
  double magnitude = 1;
  double phase_rad = 0;      ///< -π..π
  double group_delay_s = 0;  ///< NaN where the magnitude is 0
};

/// Response of filters in series.
[[nodiscard]] ResponsePoint chain_response(std::span<FilterDesign const> chain, Hertz frequency,
                                           CycleTime cycle_time);

/// What a step and an impulse show, computed with the chain's own sections in double.
struct StepFigures {
  double overshoot = 0;  ///< largest excess of the step response above its final value, as a share of the
                         ///< final value; 0 where the final value is 0
  double peak_gain = 0;  ///< Σ|h[n]|: no bounded input is amplified more
  std::optional<std::uint64_t> settling_cycles;  ///< first cycle from which the step response stays within
      ///< `tolerance` of its final value; none: not within `longest`
};

/// Cost: proportional to settling time; at most `longest` cycles.
[[nodiscard]] StepFigures step_figures(std::span<FilterDesign const> chain, std::uint64_t longest,
                                       double tolerance);

/// Group delay at 0 Hz of the chain in cycles.
[[nodiscard]] double chain_delay_cycles(std::span<FilterDesign const> chain);

}  // namespace axisc::design
