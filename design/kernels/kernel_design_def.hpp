// The whole way from specification to rounded tail sums in one number type.
#pragma once

#include "design/kernels/kernel_design.hpp"
#include "design/kernels/kernel_readings_def.hpp"
#include "design/kernels/vibration_guard_def.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace axisc::design {

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

/// Any taps: y[n] = Σ b_k x[n-k] with Σ b = 1.
template <typename Number>
void store_taps(std::vector<Number> const& taps, KernelDesign& design) {
  std::size_t const count = taps.size() - 1;
  design.tail_sums.resize(count);
  design.taps.resize(taps.size());
  Number tail{0};
  for (std::size_t k = count; k > 0; --k) {
    tail += taps[k];
    design.tail_sums[k - 1] = rounded(tail);
    design.taps[k] = rounded(taps[k]);
  }
  design.taps[0] = rounded<Number>(taps[0]);
}

/// An even number of taps, 2m: both halves of `c`, c_0 next to the middle. Half of the direct part passes
/// through each of the two taps there.
template <typename Number>
void store_even(HalfKernel<Number> const& c, Number const& share, KernelDesign& design) {
  std::size_t const m = c.size();
  Number sum{0};
  for (Number const& tap : c) sum += tap;
  Number const scale = share / (2 * sum);
  std::vector<Number> taps(2 * m);
  for (std::size_t i = 0; i < m; ++i) taps[m - 1 - i] = taps[m + i] = scale * c[i];
  taps[m - 1] += (1 - share) / 2;
  taps[m] += (1 - share) / 2;
  store_taps(taps, design);
}

/// The kernel with all of the signal, blended with the undelayed one.
template <typename Number>
void store_undelayed_share(HalfKernel<Number> const& c, Number const& share, KernelDesign& design) {
  std::size_t const h = c.size() - 1;
  Number sum = c[0];
  for (std::size_t k = 1; k <= h; ++k) sum += 2 * c[k];
  std::vector<Number> taps(2 * h + 1);
  for (std::size_t k = 0; k <= h; ++k) taps[h - k] = taps[h + k] = share * c[k] / sum;
  taps[0] += 1 - share;
  store_taps(taps, design);
}

/// Symmetrical where the reading leaves mode 4 so: both halves of the tail sums belong together then.
template <typename Number>
[[nodiscard]] KernelDesign design_guard(KernelSpecification const& guard, CycleTime cycle_time) {
  KernelDesign design;
  std::vector<Number> const taps = guard_taps<Number>(guard, cycle_time);
  if (is_symmetrical_guard(guard)) {
    std::size_t const h = taps.size() / 2;
    design.half_width = static_cast<std::uint32_t>(h);
    store_kernel(HalfKernel<Number>(taps.begin() + static_cast<std::ptrdiff_t>(h), taps.end()), Number(1),
                 design);
    design.delay_cycles = design.half_width;
    design.group_delay_cycles = static_cast<double>(h);
    return design;
  }
  store_taps(taps, design);
  design.delay_cycles = static_cast<std::uint32_t>(taps.size() - 1);
  Number delay{0};
  for (std::size_t k = 1; k < taps.size(); ++k) delay += taps[k] * static_cast<unsigned>(k);
  design.group_delay_cycles = rounded(delay);
  return design;
}

template <typename Number>
[[nodiscard]] KernelDesign design_kernel_in(KernelSpecification const& specification, CycleTime cycle_time) {
  if (passes_unchanged(specification)) return {};
  if (specification.type == KernelType::vibration_guard) {
    return design_guard<Number>(specification, as_read(cycle_time, specification.cycle_time));
  }
  KernelReading const reading = applied_reading(specification);
  KernelDesign design;
  design.group_delay_cycles = kernel_delay_cycles(specification, cycle_time);
  Number const share =
      reading == KernelReading::share_ignored ? Number(1) : Number(specification.share_percent) / 100;
  std::uint32_t const taps = tap_count(specification, cycle_time);
  if (specification.type == KernelType::time_delay) {
    design.delay_cycles = specification.order;
    store_delay(specification.order, share, design);
    return design;
  }
  bool const is_symmetrical = taps % 2 == 1 && reading != KernelReading::share_undelayed;
  if (is_symmetrical) design.half_width = taps / 2;
  design.delay_cycles = is_symmetrical ? taps / 2 : taps - 1;
  auto const half = half_kernel<Number>(specification, as_read(cycle_time, specification.cycle_time), taps);
  if (taps % 2 == 0) {
    store_even(half, share, design);
  } else if (is_symmetrical) {
    store_kernel(half, share, design);
  } else {
    store_undelayed_share(half, share, design);
  }
  return design;
}

}  // namespace axisc::design
