#include "analysis/tuning/rigid_model/window.hpp"

#include <numeric>

namespace axisc::tuning {

namespace {

/// f(k-1) - 2 f(k) + f(k+1), divided by T²; 0 outside.
std::vector<double> second_differences(std::vector<double> const& f, double T) {
  std::vector<double> found(f.size());
  for (std::size_t k = 0; k < f.size(); ++k) {
    double const before = k > 0 ? f[k - 1] : 0;
    double const after = k + 1 < f.size() ? f[k + 1] : 0;
    found[k] = (before - 2 * f[k] + after) / (T * T);
  }
  return found;
}

}  // namespace

Window make_window(std::size_t length, double T) {
  Window window;
  auto const n = static_cast<double>(length);
  for (std::size_t k = 0; k < length; ++k) {
    double const s = (2 * static_cast<double>(k) - (n - 1)) / (n + 1);
    double const square = (1 - s * s) * (1 - s * s);
    window.weights.push_back(square * square);
  }
  double const sum = std::accumulate(window.weights.begin(), window.weights.end(), 0.0);
  for (double& weight : window.weights) weight /= sum;
  std::vector<double> padded(length + 2 * window_margin, 0.0);
  std::copy(window.weights.begin(), window.weights.end(), padded.begin() + window_margin);
  window.velocity.assign(padded.size(), 0.0);
  for (std::size_t k = 1; k + 1 < padded.size(); ++k) {
    window.velocity[k] = (padded[k - 1] - padded[k + 1]) / (2 * T);
  }
  window.acceleration = second_differences(padded, T);
  window.fourth = second_differences(window.acceleration, T);
  return window;
}

double derivative_at(std::span<double const> weights, std::span<double const> values) {
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * (values[k] - values[0]);
  return sum;
}

}  // namespace axisc::tuning
