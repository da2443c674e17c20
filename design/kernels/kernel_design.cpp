#include "design/kernels/kernel_design.hpp"

#include "design/kernels/kernel_kinds.hpp"
#include "design/kernels/vibration_guard_def.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axisc::design {
namespace {

/// The frequency in Hz whose period is 2n + 1 cycles; one rounding, because the divisor is a whole number.
double frequency_of_period(std::uint32_t n, CycleTime cycle_time) {
  return 1e9 / (double(cycle_time.nanoseconds) * (2.0 * n + 1));
}

/// n of the longest NoVib kernel.
constexpr std::uint32_t longest_novib_box = longest_kernel_order / 4;
/// Where the search for n ends: far above what fits, far below overflow of the order.
constexpr std::uint32_t box_limit = 1'000'000;

/// n = m + 1 = ceil((fs/f0 - 1)/2), at least 1: the least n with f0 ≥ fs/(2n + 1).
std::uint32_t novib_box(Hertz frequency, CycleTime cycle_time) {
  double const f0 = frequency.value;
  if (!(f0 > frequency_of_period(box_limit, cycle_time))) return box_limit;
  double const estimate = std::ceil((1 / cycle_time.periods_in<double>(frequency) - 1) / 2);
  auto n = static_cast<std::uint32_t>(std::clamp<double>(estimate, 1, box_limit));
  while (n > 1 && f0 >= frequency_of_period(n - 1, cycle_time)) --n;
  while (f0 < frequency_of_period(n, cycle_time)) ++n;
  return n;
}

}  // namespace

bool passes_unchanged(KernelSpecification const& specification) {
  KernelReading const reading = applied_reading(specification);
  if (specification.share_percent == 0 && reading != KernelReading::share_ignored) return true;
  if (kind_of(specification.type).computes_order) return false;
  bool const is_narrower =
      reading == KernelReading::taps_n || reading == KernelReading::half_width_rounded_down;
  return specification.order == 0 || (is_narrower && specification.order == 1);
}

std::uint32_t tap_count(KernelSpecification const& specification, CycleTime cycle_time) {
  if (passes_unchanged(specification)) return 1;
  if (specification.type == KernelType::vibration_guard) {
    auto const computed_for = as_read(cycle_time, specification.cycle_time);
    return static_cast<std::uint32_t>(guard_taps<double>(specification, computed_for).size());
  }
  std::uint32_t const N = specification.order;
  if (specification.type == KernelType::time_delay) return N + 1;
  switch (applied_reading(specification)) {
    case KernelReading::taps_n: return N;
    case KernelReading::taps_n_plus_1: return N + 1;
    case KernelReading::half_width_rounded_down: return 2 * (N / 2) + 1;
    case KernelReading::order_is_half_width: return 2 * N + 1;
    case KernelReading::novib_one_box:
      return novib_order(specification.frequency, as_read(cycle_time, specification.cycle_time)) / 2 + 1;
    default: break;
  }
  if (specification.type == KernelType::novib) {
    return novib_order(specification.frequency, as_read(cycle_time, specification.cycle_time)) + 1;
  }
  return 2 * (N / 2 + N % 2) + 1;
}

std::uint32_t longest_order(KernelType type, KernelReading reading) {
  std::uint32_t const longest = kind_of(type).longest_order;
  bool const is_twice_as_wide =
      applied_reading({.type = type, .reading = reading}) == KernelReading::order_is_half_width;
  return is_twice_as_wide ? longest / 2 : longest;
}

double kernel_delay_cycles(KernelSpecification const& specification, CycleTime cycle_time) {
  if (specification.type == KernelType::vibration_guard) {
    return design_kernel(specification, cycle_time).group_delay_cycles;
  }
  double const whole = tap_count(specification, cycle_time) - 1;
  KernelReading const reading = applied_reading(specification);
  double const share = specification.share_percent / 100;
  if (specification.type == KernelType::time_delay) {
    return reading == KernelReading::share_ignored ? whole : specification.share_percent * whole / 100;
  }
  return reading == KernelReading::share_undelayed ? share * whole / 2 : whole / 2;
}

std::optional<std::uint32_t> order_of_time(Microseconds time, CycleTime cycle_time) {
  double const T = cycle_time.nanoseconds;
  double const nanoseconds = time.value * 1000;
  if (!(nanoseconds >= T)) return std::nullopt;
  constexpr auto largest = std::numeric_limits<std::uint32_t>::max();
  if (nanoseconds / T >= largest) return largest;
  // Remainder and quotient are exact, so that the numbers decide about half a cycle, not rounding.
  double const remainder = std::fmod(nanoseconds, T);
  auto const whole = static_cast<std::uint32_t>((nanoseconds - remainder) / T);
  return whole + (2 * remainder >= T ? 1U : 0U);
}

std::uint32_t novib_order(Hertz frequency, CycleTime cycle_time) {
  return 4 * novib_box(frequency, cycle_time);
}

Hertz lowest_novib_frequency(CycleTime cycle_time) {
  return {frequency_of_period(longest_novib_box, cycle_time)};
}

}  // namespace axisc::design
