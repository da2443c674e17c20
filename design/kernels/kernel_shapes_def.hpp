// Shapes of the symmetrical kernels. Each function gives the taps of one half, c_0 (the centre) to c_h, in
// any scale: to be divided by  c_0 + 2 Σ_{k=1..h} c_k.
#pragma once

#include "design/phasor_def.hpp"
#include "design/pi_def.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace axisc::design {

template <typename Number>
using HalfKernel = std::vector<Number>;

template <typename Number>
[[nodiscard]] HalfKernel<Number> moving_average(std::uint32_t h) {
  return HalfKernel<Number>(h + 1, Number(1));
}

/// c_k = exp(-½ (k/σ)²), σ = quality·h/2.5. With q = exp(-½/σ²):  c_(k+1) = c_k q^(2k+1).
template <typename Number>
[[nodiscard]] HalfKernel<Number> gaussian(std::uint32_t h, Number const& quality) {
  using std::exp;
  Number const sigma = quality * h * 2 / 5;
  Number const q = exp(-1 / (2 * sigma * sigma));
  Number const q_squared = q * q;
  HalfKernel<Number> c{Number(1)};
  Number ratio = q;
  for (std::uint32_t k = 1; k <= h; ++k) {
    c.push_back(c.back() * ratio);
    ratio *= q_squared;
  }
  return c;
}

/// c_k = sin(kθ)/k · (54 + 46 cos(πk/h)), c_0 = 100 θ, θ = 2π fcut T: the sinc in Hamming's window, times 100
/// θ.
template <typename Number>
[[nodiscard]] HalfKernel<Number> windowed_sinc(std::uint32_t h, Number const& theta) {
  Phasor<Number> carrier(theta, theta);
  Number const window_step = pi<Number>() / h;
  Phasor<Number> window(window_step, window_step);
  HalfKernel<Number> c{100 * theta};
  for (std::uint32_t k = 1; k <= h; ++k) {
    c.push_back(carrier.sine() * (54 + 46 * window.cosine()) / k);
    carrier.advance();
    window.advance();
  }
  return c;
}

/// w = -(1 + 2 Σ_{k=1..n-1} cos kθ) / (2 cos nθ): taps of 1 for |k| < n and of w at ±n have no gain at θ.
template <typename Number>
[[nodiscard]] Number novib_edge_weight(std::uint32_t n, Number const& theta) {
  Phasor<Number> phasor(theta, theta);
  Number sum{1};
  for (std::uint32_t k = 1; k < n; ++k) {
    sum += 2 * phasor.cosine();
    phasor.advance();
  }
  return -sum / (2 * phasor.cosine());
}

/// That box of 2n + 1 taps, edges w, convolved with itself: h = 2n.
///     c_0 = 2n - 1 + 2w²,  c_k = 2n - 1 - k + 2w  (0 < k < 2n),  c_2n = w²
template <typename Number>
[[nodiscard]] HalfKernel<Number> novib(std::uint32_t n, Number const& theta) {
  Number const w = novib_edge_weight(n, theta);
  HalfKernel<Number> c{2 * n - 1 + 2 * w * w};
  for (std::uint32_t k = 1; k < 2 * n; ++k) c.push_back(2 * n - 1 - k + 2 * w);
  c.push_back(w * w);
  return c;
}

}  // namespace axisc::design
