// Where readings put the poles of a prototype that is normalised to -3 dB at s = j.
#pragma once

#include "design/pi_def.hpp"
#include "design/prototypes_def.hpp"
#include "design/readings.hpp"

#include <cmath>
#include <limits>

namespace axisc::design {

/// |H(jω)|² of the low-pass with these poles.
template <typename Number>
[[nodiscard]] Number power_at(Poles<Number> const& poles, Number const& omega) {
  Number power{1};
  for (auto const& p : poles) {
    Number const below = p.re * p.re + (omega - p.im) * (omega - p.im);
    if (p.im == 0) {
      power *= p.re * p.re / below;
    } else {
      Number const above = p.re * p.re + (omega + p.im) * (omega + p.im);
      power *= square_of_magnitude(p) * square_of_magnitude(p) / (below * above);
    }
  }
  return power;
}

/// The angle by which that low-pass lags at ω, from 0 to π/2 a pole.
template <typename Number>
[[nodiscard]] Number lag_at(Poles<Number> const& poles, Number const& omega) {
  using std::atan;
  Number lag{0};
  for (auto const& p : poles) {
    lag += atan(Number((p.im - omega) / p.re));
    if (p.im != 0) lag += atan(Number((-p.im - omega) / p.re));
  }
  return lag;
}

/// Its delay at ω = 0: Σ -1/p.
template <typename Number>
[[nodiscard]] Number delay_at_rest(Poles<Number> const& poles) {
  Number delay{0};
  for (auto const& p : poles) delay -= (p.im == 0 ? 1 : 2) * p.re / square_of_magnitude(p);
  return delay;
}

/// The ω > 0 at which a function that rises through 0 does so.
template <typename Number, typename Function>
[[nodiscard]] Number crossing(Function const& rises) {
  Number low{0}, high{1};
  while (rises(high) < 0) high *= 2;
  for (int i = 0; i <= std::numeric_limits<Number>::digits; ++i) {
    Number const middle = (low + high) / 2;
    (rises(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// The factor of the poles; the reading is one that applies to the filter.
template <typename Number>
[[nodiscard]] Number pole_scale(FilterReading reading, Poles<Number> const& poles) {
  switch (reading) {
    case FilterReading::poles_at_frequency:
    case FilterReading::quality_of_poles:  // equal real poles
      return -1 / poles.front().re;
    case FilterReading::half_gain_at_frequency:
      return 1 /
             crossing<Number>([&](Number const& omega) { return Number(1 - 4 * power_at(poles, omega)); });
    case FilterReading::bessel_delay: return delay_at_rest(poles);
    case FilterReading::allpass_phase: {
      int count = 0;
      for (auto const& p : poles) count += p.im == 0 ? 1 : 2;
      Number const half = count * pi<Number>() / 4;
      return 1 / crossing<Number>([&](Number const& omega) { return Number(lag_at(poles, omega) - half); });
    }
    case FilterReading::documented:
    case FilterReading::no_prewarping:
    case FilterReading::backward_euler:
    case FilterReading::forward_euler:
    case FilterReading::matched:
    case FilterReading::matched_poles:
    case FilterReading::analogue_quality: break;
  }
  return Number(1);
}

}  // namespace axisc::design
