#include "analysis/comparison/liveliness.hpp"

#include <cmath>
#include <numeric>

namespace axisc::comparison {

namespace {

/// How much the velocity changes in each stretch of the signal.
std::vector<double> bends_of(Signal const& signal, std::size_t stretch) {
  std::vector<double> bends(signal.size() / stretch + 1, 0.0);
  double last = signal.front();
  double velocity = 0;
  for_each_part(signal, [&](std::size_t first, std::span<double const> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      double const step = values[i] - last;
      bends[(first + i) / stretch] += std::abs(step - velocity);
      velocity = step;
      last = values[i];
    }
  });
  return bends;
}

}  // namespace

std::size_t liveliest_part(Signal const& signal, std::size_t length) {
  if (signal.size() <= length || length < 4) return 0;
  std::size_t const stretch = length / 4;
  auto const bends = bends_of(signal, stretch);
  std::size_t best = 0;
  double most = -1;
  for (std::size_t begin = 0; begin + length <= signal.size(); begin += stretch) {
    auto const from = bends.begin() + static_cast<std::ptrdiff_t>(begin / stretch);
    auto const to = bends.begin() + static_cast<std::ptrdiff_t>((begin + length) / stretch);
    double const sum = std::accumulate(from, to, 0.0);
    if (sum > most) {
      most = sum;
      best = begin;
    }
  }
  return best;
}

}  // namespace axisc::comparison
