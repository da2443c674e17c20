// A smooth window and its derivatives, which turn a recorded position into means of velocity and
// acceleration without differentiating it.
//
//     φ(s) = (1 - s²)⁴,  -1 < s < 1,  Σ φ_k = 1
// With central differences, summed by parts (exact, because φ is 0 outside):
//     Σ φ_k (x_{k+1} - x_{k-1}) / 2T           = Σ x_k (φ_{k-1} - φ_{k+1}) / 2T
//     Σ φ_k (x_{k+1} - 2 x_k + x_{k-1}) / T²   = Σ x_k (φ_{k+1} - 2 φ_k + φ_{k-1}) / T²
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::tuning {

/// Samples before and after a window that its derivatives reach.
inline constexpr std::size_t window_margin = 2;

struct Window {
  std::vector<double> weights;  ///< φ_k, of each sample of the window

  // Weights of the positions, from window_margin samples before the window to as many after it.
  std::vector<double> velocity;
  std::vector<double> acceleration;
  std::vector<double> fourth;  ///< derivative of the position

  [[nodiscard]] std::size_t length() const { return weights.size(); }
};

/// T in s.
[[nodiscard]] Window make_window(std::size_t length, double T);

/// Σ weights (values - values[0]), as all weights of derivatives sum up to 0.
[[nodiscard]] double derivative_at(std::span<double const> weights, std::span<double const> values);

}  // namespace axisc::tuning
