// The half of a kernel that a specification asks for, in the reading of the control.
#pragma once

#include "design/kernels/kernel_kinds.hpp"
#include "design/kernels/kernel_shapes_def.hpp"
#include "design/pi_def.hpp"

#include <cmath>
#include <cstdint>

namespace axisc::design {

/// θ = 2π f T
template <typename Number>
[[nodiscard]] Number angle_per_cycle(Hertz frequency, CycleTime cycle_time) {
  return 2 * pi<Number>() * cycle_time.periods_in<Number>(frequency);
}

/// h/σ of the Gaussian at quality 1, times 2.
[[nodiscard]] constexpr int twice_gaussian_width(KernelReading reading) {
  switch (reading) {
    case KernelReading::gaussian_width_1: return 2;
    case KernelReading::gaussian_width_2: return 4;
    case KernelReading::gaussian_width_3: return 6;
    default: break;
  }
  return 5;
}

/// The window at x = k/h, in hundredths.
template <typename Number>
[[nodiscard]] Number window_at(KernelReading reading, Number const& x) {
  using std::cos;
  Number const angle = pi<Number>() * x;
  switch (reading) {
    case KernelReading::sinc_no_window: return Number(100);
    case KernelReading::sinc_hann: return Number(50 + 50 * cos(angle));
    case KernelReading::sinc_blackman: return Number(42 + 50 * cos(angle) + 8 * cos(Number(2 * angle)));
    default: break;
  }
  return Number(54 + 46 * cos(angle));
}

/// Tap at the distance k from the middle of a kernel of half width h, in any scale.
template <typename Number>
[[nodiscard]] Number weight(KernelSpecification const& wanted, CycleTime cycle_time, Number const& k,
                            Number const& h) {
  using std::exp;
  using std::sin;
  KernelReading const reading = applied_reading(wanted);
  if (wanted.type == KernelType::gaussian) {
    Number const sigma = Number(wanted.quality) * h * 2 / twice_gaussian_width(reading);
    Number const x = k / sigma;
    return exp(Number(-x * x / 2));
  }
  if (wanted.type != KernelType::windowed_sinc) return Number(1);
  Number const angle = angle_per_cycle<Number>(wanted.frequency, cycle_time) * k;
  Number const sinc = k == 0 ? Number(1) : Number(sin(angle) / angle);
  return sinc * window_at(reading, Number(k / h));
}

template <typename Number>
[[nodiscard]] HalfKernel<Number> documented_half(KernelSpecification const& wanted, CycleTime cycle_time,
                                                 std::uint32_t h) {
  switch (wanted.type) {
    case KernelType::gaussian: return gaussian(h, Number(wanted.quality));
    case KernelType::windowed_sinc:
      return windowed_sinc(h, angle_per_cycle<Number>(wanted.frequency, cycle_time));
    case KernelType::novib: return novib(h / 2, angle_per_cycle<Number>(wanted.frequency, cycle_time));
    case KernelType::moving_average:
    case KernelType::time_delay:  // not symmetrical
    case KernelType::vibration_guard: break;
  }
  return moving_average<Number>(h);
}

/// c_0 in the middle, or with an even number of taps next to it, and so on to the last one.
template <typename Number>
[[nodiscard]] HalfKernel<Number> half_kernel(KernelSpecification const& wanted, CycleTime cycle_time,
                                             std::uint32_t taps) {
  KernelReading const reading = applied_reading(wanted);
  bool const has_documented_shape =
      twice_gaussian_width(reading) == twice_gaussian_width(KernelReading::documented) &&
      reading != KernelReading::sinc_hann && reading != KernelReading::sinc_blackman &&
      reading != KernelReading::sinc_no_window;
  if (reading == KernelReading::novib_one_box) {
    std::uint32_t const n = taps / 2;
    HalfKernel<Number> box(n + 1, Number(1));
    box.back() = novib_edge_weight(n, angle_per_cycle<Number>(wanted.frequency, cycle_time));
    return box;
  }
  if (taps % 2 == 1 && has_documented_shape) return documented_half<Number>(wanted, cycle_time, taps / 2);
  Number const h = Number(taps - 1) / 2;
  HalfKernel<Number> half;
  for (Number k = taps % 2 == 1 ? Number(0) : Number(1) / 2; k <= h; k += 1) {
    half.push_back(weight(wanted, cycle_time, k, h));
  }
  return half;
}

}  // namespace axisc::design
