#include "analysis/recordings/time_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace axisc::recordings {

double usual_step(Signal const& times) {
  if (times.size() < 2) return 0;
  constexpr std::size_t most = 100'000;
  std::size_t const every = (times.size() - 2) / most + 1;
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); i += every) {
    std::array<double, 2> pair{};
    times.read(i - 1, pair);
    steps.push_back(pair[1] - pair[0]);
  }
  auto const middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  double const median = *middle;
  double sum = 0;
  std::size_t count = 0;
  for (double const step : steps) {
    if (std::abs(step - median) > median / 2) continue;
    sum += step - median;
    ++count;
  }
  return median + sum / static_cast<double>(count);
}

}  // namespace axisc::recordings
