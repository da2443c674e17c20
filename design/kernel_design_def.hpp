// The whole way from specification to rounded tail sums in one number type.
#pragma once

#include "design/kernel_design.hpp"
#include "design/kernel_shapes_def.hpp"
#include "design/pi_def.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace axisc::design {

/// θ = 2π f T
template <typename Number>
[[nodiscard]] Number angle_per_cycle(Hertz frequency, CycleTime cycle_time) {
  return 2 * pi<Number>() * cycle_time.periods_in<Number>(frequency);
}

template <typename Number>
[[nodiscard]] HalfKernel<Number> half_kernel(KernelSpecification const& specification, CycleTime cycle_time) {
  std::uint32_t const h = half_width(specification, cycle_time);
  switch (specification.type) {
    case KernelType::gaussian:
      return gaussian(h, Number(specification.quality));
    case KernelType::windowed_sinc:
      return windowed_sinc(h, angle_per_cycle<Number>(specification.frequency, cycle_time));
    case KernelType::novib:
      return novib(h / 2, angle_per_cycle<Number>(specification.frequency, cycle_time));
    case KernelType::moving_average:
      return moving_average<Number>(h);
    case KernelType::time_delay:  // not symmetrical
      break;
  }
  assert(false);
  return {};
}

/// The nearest double; 0 below the normal ones, with which processors disagree.
template <typename Number>
[[nodiscard]] double rounded(Number const& x) {
  auto const nearest = static_cast<double>(x);
  return std::abs(nearest) < std::numeric_limits<double>::min() ? 0.0 : nearest;
}

/// With the share s and T_i = s Σ_{k>i} c_k / Σ c, symmetry gives both halves of the tail sums:
///     S_(h+i) = T_i,  S_(h-1-i) = 1 - T_i
/// and only the centre tap has the direct part:  b_0 = s c_0 / Σ c + 1 - s.
template <typename Number>
void store_kernel(HalfKernel<Number> const& c, Number const& share, KernelDesign& design) {
  std::size_t const h = c.size() - 1;
  HalfKernel<Number> tails(h + 1, Number(0));
  for (std::size_t k = h; k > 0; --k) tails[k - 1] = tails[k] + c[k];
  Number const scale = share / (c[0] + 2 * tails[0]);

  design.tail_sums.resize(2 * h);
  design.taps.resize(2 * h + 1);
  design.taps[h] = rounded<Number>(scale * c[0] + (1 - share));
  for (std::size_t k = 1; k <= h; ++k) {
    design.taps[h - k] = design.taps[h + k] = rounded<Number>(scale * c[k]);
    Number const tail = scale * tails[k - 1];
    design.tail_sums[h + k - 1] = rounded(tail);
    design.tail_sums[h - k] = rounded<Number>(1 - tail);
  }
}

/// s at z^-N plus 1 - s undelayed: S_0 to S_(N-1) are s.
template <typename Number>
void store_delay(std::uint32_t cycles, Number const& share, KernelDesign& design) {
  design.tail_sums.assign(cycles, rounded(share));
  design.taps.assign(cycles + 1, 0.0);
  design.taps.front() = rounded<Number>(1 - share);
  design.taps.back() = rounded(share);
}

template <typename Number>
[[nodiscard]] KernelDesign design_kernel_in(KernelSpecification const& specification, CycleTime cycle_time) {
  if (passes_unchanged(specification)) return {};
  KernelDesign design;
  design.half_width = half_width(specification, cycle_time);
  design.group_delay_cycles = kernel_delay_cycles(specification, cycle_time);
  Number const share = Number(specification.share_percent) / 100;
  if (specification.type == KernelType::time_delay) {
    design.delay_cycles = specification.order;
    store_delay(specification.order, share, design);
  } else {
    design.delay_cycles = design.half_width;
    store_kernel(half_kernel<Number>(specification, cycle_time), share, design);
  }
  return design;
}

}  // namespace axisc::design
