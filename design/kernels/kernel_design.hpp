// FIR kernels: `filter_fir`, the HSC filters (spec "filter mathematics", section 2) and Vibration Guard.
//
// A kernel b_k, k = -h..h, sums to 1 and is handed on as tail sums  S_j = Σ_{k>j} b_k  of the causal taps,
// each rounded once, so that  y[n] = x[n] - Σ_j S_j d[n-j],  d[n] = x[n] - x[n-1],  has DC gain 1 by
// construction.
//
//   moving average  constant (HSC mean is the same)
//   Gaussian        exp(-½ (k/σ)²), σ = quality·h/2.5
//   windowed sinc   sinc(2 fcut T k)·(0.54 + 0.46 cos(πk/h))
//   time delay      δ(k - N), not symmetrical
//   NoVib           a box of one period of f0, convolved with itself: a double zero on f0
//   Vibration Guard two to four impulses, half a damped period apart (design/kernels/vibration_guard.hpp)
//
// Order N means h = ceil(N/2), 2h + 1 taps and a delay of h cycles. The share s blends through the centre
// tap, b'_k = s b_k + (1 - s) δ_k, which keeps the phase linear; the time delay blends with the undelayed
// signal; Vibration Guard has no share. Other readings (design/readings.hpp) have other widths, shapes or
// shares; with an even number of taps the delay has half a cycle in it, and the share passes half through
// each of the two taps in the middle.
#pragma once

#include "design/readings.hpp"
#include "design/units.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::design {

enum class KernelType : std::uint8_t {
  moving_average,
  gaussian,
  windowed_sinc,
  time_delay,
  novib,
  vibration_guard
};

/// Largest order of every kernel but the time delay.
inline constexpr std::uint32_t longest_kernel_order = 200;
/// Largest order of the time delay.
inline constexpr std::uint32_t longest_kernel_delay = 100;
/// Tail sums of the longest Vibration Guard that a runtime takes.
inline constexpr std::uint32_t longest_guard = 960;

/// Ranges: order 1..200 (time_delay 1..100; MODE of Vibration Guard, 1..4), 0 is off; frequency: cut-off of
/// the windowed sinc, or the frequency that NoVib (see lowest_novib_frequency) or Vibration Guard suppresses,
/// 0 < f < 0.5/T, ignored by the others; quality: of the Gaussian, 0 < q ≤ 1, or the damping ratio D of
/// Vibration Guard, 0 ≤ D < 1; share_percent 0..100 (0 passes the signal on undelayed).
struct KernelSpecification {
  KernelType type = KernelType::moving_average;
  std::uint32_t order = 1;  ///< computed by NoVib itself
  Hertz frequency{30};
  double quality = 1;
  double share_percent = 100;
  KernelReading reading = KernelReading::documented;  ///< see applied_reading()
  CycleReading cycle_time = CycleReading::documented;

  friend constexpr bool operator==(KernelSpecification const&, KernelSpecification const&) = default;
};

struct KernelDesign {
  /// h; 0 for the time delay, modes 1 to 3 of Vibration Guard, an even number of taps, and where the signal
  /// passes unchanged
  std::uint32_t half_width = 0;
  std::uint32_t delay_cycles = 0;  ///< h where that is not 0, else as many as there are tail sums
  double group_delay_cycles =
      0;  ///< at 0 Hz; not a whole number with an even number of taps, where a delay blends, and for a guard
  std::vector<double> tail_sums{};  ///< S_0, S_1, …: 2h or N of them; empty where the signal passes unchanged
  std::vector<double> taps{1.0};    ///< causal taps b_0, b_1, …, share included, for display and analysis
  double kernel_sum = 1;            ///< of the taps that the tail sums represent: telescopes to exactly 1
};

/// Kernel in 50 decimal digits, each number rounded once (below 2^-1022 it is 0); identical on every host.
/// Expects a specification within its ranges. Cost: up to 0.3 ms.
[[nodiscard]] KernelDesign design_kernel(KernelSpecification const& specification, CycleTime cycle_time);

/// The specification's reading, or `documented` where that one means nothing for the kernel.
[[nodiscard]] KernelReading applied_reading(KernelSpecification const& specification);

/// A share of 0 %, order 0 where the order is not computed, or a single tap.
[[nodiscard]] bool passes_unchanged(KernelSpecification const& specification);
/// How many taps the kernel has, without designing it; 1 where the signal passes unchanged.
[[nodiscard]] std::uint32_t tap_count(KernelSpecification const& specification, CycleTime cycle_time);
/// Largest order of a type whose kernel has no more tail sums than a runtime takes.
[[nodiscard]] std::uint32_t longest_order(KernelType type, KernelReading reading);
/// Delay at 0 Hz in cycles, without designing the kernel, unless it is a guard.
[[nodiscard]] double kernel_delay_cycles(KernelSpecification const& specification, CycleTime cycle_time);

/// N = floor(time / T + 0.5), without rounding errors for whole nanoseconds; none where time < T (the filter
/// is off).
[[nodiscard]] std::optional<std::uint32_t> order_of_time(Microseconds time, CycleTime cycle_time);

/// 4 (m + 1) = 4 ceil((fs/f0 - 1)/2), at least 4; above longest_kernel_order the frequency is too low for
/// this cycle time. fs/f0 counts as the odd number 2n + 1 where f0 is the double nearest to fs/(2n + 1), so
/// that the result of lowest_novib_frequency works. Saturates at 4e6, also for frequencies that are not
/// positive.
[[nodiscard]] std::uint32_t novib_order(Hertz frequency, CycleTime cycle_time);
/// fs/101.
[[nodiscard]] Hertz lowest_novib_frequency(CycleTime cycle_time);

}  // namespace axisc::design
