// Linear-phase FIR kernels: `filter_fir` and the HSC filters (spec "filter mathematics", section 2).
//
// A kernel b_k, k = -h..h, sums to 1 and is handed on as tail sums  S_j = Σ_{k>j} b_k  of the causal taps, each rounded
// once, so that  y[n] = x[n] - Σ_j S_j d[n-j],  d[n] = x[n] - x[n-1],  has DC gain 1 by construction.
#pragma once

#include "design/units.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::design {

enum class KernelType : std::uint8_t { moving_average, gaussian, windowed_sinc, time_delay, novib };

/// Ranges: order 1..200 (time_delay 1..100); frequency: cut-off of the windowed sinc, 0 < f < 0.5/T, or the frequency that
/// NoVib suppresses (see lowest_novib_frequency), ignored by the others; quality: Gaussian only, 0 < q ≤ 1;
/// share_percent 0..100 (0 passes the signal on undelayed).
struct KernelSpecification {
  KernelType type = KernelType::moving_average;
  std::uint32_t order = 1;  ///< computed by NoVib itself
  Hertz frequency{30};
  double quality = 1;
  double share_percent = 100;

  friend constexpr bool operator==(KernelSpecification const&, KernelSpecification const&) = default;
};

struct KernelDesign {
  std::uint32_t half_width = 0;     ///< h; the time delay has none
  std::uint32_t delay_cycles = 0;   ///< h, or the order of the time delay; 0 for share 0
  std::vector<double> tail_sums;    ///< S_0, S_1, …; empty where the signal passes unchanged
  std::vector<double> taps;         ///< causal taps b_0, b_1, …, share included, for display and analysis
  double kernel_sum = 1;            ///< exact sum of the taps
};

/// Kernel in 50 decimal digits, rounded once; identical on every host.
[[nodiscard]] KernelDesign design_kernel(KernelSpecification const& specification, CycleTime cycle_time);

/// N = floor(time / T + 0.5); none where time < T (the filter is off).
[[nodiscard]] std::optional<std::uint32_t> order_of_time(Microseconds time, CycleTime cycle_time);

/// m of NoVib's box, and the order 4 (m + 1) that results; above 200 the frequency is too low for this cycle time.
[[nodiscard]] std::uint32_t novib_order(Hertz frequency, CycleTime cycle_time);
/// fs/101.
[[nodiscard]] Hertz lowest_novib_frequency(CycleTime cycle_time);

}  // namespace axisc::design
