// Analysis of a chain of designed filters: frequency response, overshoot, peak gain, settling.
#pragma once

#include "design/filter_design.hpp"

#include <complex>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace axisc::design {

/// Complex response of one filter, share included, at `frequency`. Accurate to about 1e-13 also next to 0 Hz.
[[nodiscard]] std::complex<double> response(FilterDesign const& filter, Hertz frequency,
                                            CycleTime cycle_time);

struct ResponsePoint {
  double magnitude = 1;
  double phase_rad = 0;      ///< -π..π
  double group_delay_s = 0;  ///< NaN where the magnitude is 0, or rounding of 0
};

/// Response of filters in series.
[[nodiscard]] ResponsePoint chain_response(std::span<FilterDesign const> chain, Hertz frequency,
                                           CycleTime cycle_time);

/// Filters in series, and the weight of their output.
struct WeightedChain {
  double weight = 1;
  std::vector<FilterDesign> filters{};
};

/// Response of the weighted sum of chains that all get the same input.
[[nodiscard]] ResponsePoint parallel_response(std::span<WeightedChain const> chains, Hertz frequency,
                                              CycleTime cycle_time);

/// Figures of the responses to a unit step and a unit impulse, computed with the chain's own sections in
/// double.
struct StepFigures {
  /// Largest excess of the step response above its final value, as a share of the final value; 0 where that
  /// is 0.
  double overshoot = 0;
  /// Σ|h[n]| over the time looked at: a bounded input is amplified as much.
  double peak_gain = 0;
  /// No bounded input is amplified more: Σ|h[n]|, and the most that rounding and the time not looked at may
  /// add to it.
  double peak_gain_bound = 0;
  /// First cycle from which the step response stays within `tolerance` (a share of the step) of its final
  /// value; none where it is not certain to do so within `longest` cycles.
  std::optional<std::uint64_t> settling_cycles;
  /// First cycle from which the step response was within `tolerance` as long as it was looked at.
  std::uint64_t within_from = 0;
};

/// Long enough for peak gains of all filters but those whose characteristic frequency is some millionths of
/// the sampling rate.
inline constexpr std::uint64_t longest_summation = std::uint64_t{1} << 21U;

/// Stops as soon as what is left in the states changes none of the figures (13 digits), at the latest after
/// `longest` cycles: overshoot and peak gain are then those of the time looked at, and the latter's bound is
/// far above it.
/// The figures are the same on every host: sums and products in double in a fixed order, and square roots.
/// Cost: about 5 ns per section and cycle.
[[nodiscard]] StepFigures step_figures(std::span<FilterDesign const> chain, std::uint64_t longest,
                                       double tolerance);
/// StepFigures::overshoot alone, which needs fewer cycles. Cost: half of step_figures().
[[nodiscard]] double step_overshoot(std::span<FilterDesign const> chain, std::uint64_t longest);
/// StepFigures::within_from alone; none where the step response is not within `tolerance` after `longest`
/// cycles. What a filter before a blocking one, or one with a tiny share, still has to do need not show.
/// Cost: as above.
[[nodiscard]] std::optional<std::uint64_t> settling_cycles(std::span<FilterDesign const> chain,
                                                           std::uint64_t longest, double tolerance);

/// A number of cycles after which the step response certainly stays within `tolerance` of its final value;
/// infinite where none can be given. Often three times the cycles needed, but found without simulating
/// (Cauchy's estimate of the error's z-transform on circles around its poles). The search stops at `enough`.
/// Cost: about 1 µs.
[[nodiscard]] double settling_bound(std::span<FilterDesign const> chain, double tolerance, double enough = 0);

/// Group delay at 0 Hz of the chain in cycles.
[[nodiscard]] double chain_delay_cycles(std::span<FilterDesign const> chain);

}  // namespace axisc::design
