// Figures of a sample.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace axisc::motion {

/// Of one value at least.
[[nodiscard]] inline double mean(std::span<double const> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The upper one of the two in the middle. Of one value at least.
[[nodiscard]] inline double median(std::vector<double> values) {
  auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Σ (x - x̄)² / n. Of one value at least.
[[nodiscard]] inline double variance(std::span<double const> values) {
  double const middle = mean(values);
  double sum = 0;
  for (double const value : values) sum += (value - middle) * (value - middle);
  return sum / static_cast<double>(values.size());
}

/// √(Σ (x - x̄)² / (n - 1) / n); 0 for a single value.
[[nodiscard]] inline double standard_error(std::span<double const> values) {
  if (values.size() < 2) return 0;
  return std::sqrt(variance(values) / static_cast<double>(values.size() - 1));
}

}  // namespace axisc::motion
