#include "design/kernel_design.hpp"

#include "design/kernel_design_def.hpp"
#include "design/kernel_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_bin_float.hpp>

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

KernelDesign design_kernel(KernelSpecification const& specification, CycleTime cycle_time) {
  namespace multiprecision = boost::multiprecision;
  using Exact = multiprecision::number<multiprecision::cpp_bin_float<50>, multiprecision::et_off>;
  return design_kernel_in<Exact>(specification, cycle_time);
}

bool passes_unchanged(KernelSpecification const& specification) {
  bool const computes_order = kind_of(specification.type).computes_order;
  return specification.share_percent == 0 || (specification.order == 0 && !computes_order);
}

std::uint32_t half_width(KernelSpecification const& specification, CycleTime cycle_time) {
  if (passes_unchanged(specification)) return 0;
  switch (specification.type) {
    case KernelType::time_delay:
      return 0;
    case KernelType::novib:
      return novib_order(specification.frequency, cycle_time) / 2;
    case KernelType::moving_average:
    case KernelType::gaussian:
    case KernelType::windowed_sinc:
      break;
  }
  return specification.order / 2 + specification.order % 2;
}

double kernel_delay_cycles(KernelSpecification const& specification, CycleTime cycle_time) {
  if (passes_unchanged(specification)) return 0;
  if (specification.type == KernelType::time_delay) {
    return specification.share_percent * specification.order / 100;
  }
  return half_width(specification, cycle_time);
}

std::optional<std::uint32_t> order_of_time(Microseconds time, CycleTime cycle_time) {
  double const T = cycle_time.nanoseconds;
  double const nanoseconds = time.value * 1000;
  if (!(nanoseconds >= T)) return std::nullopt;
  constexpr auto largest = std::numeric_limits<std::uint32_t>::max();
  if (nanoseconds / T >= largest) return largest;
  // Remainder and quotient are exact, so that half a cycle is decided by the numbers and not by rounding.
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
