#include "analysis/motion/contour/position_delays.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace axisc::motion {

std::vector<machine::PositionDelay> unequal_delays(std::vector<machine::PositionDelay> const& delays) {
  if (std::adjacent_find(delays.begin(), delays.end(), std::not_equal_to<>()) == delays.end()) return {};
  double least = delays.front().cycles;
  bool has_one_lag = true;
  for (auto const& delay : delays) {
    least = std::min(least, delay.cycles);
    has_one_lag = has_one_lag && delay.lag == delays.front().lag;
  }
  auto unequal = delays;
  for (auto& delay : unequal) {
    delay.cycles -= least;
    if (has_one_lag) delay.lag = 0;
  }
  return unequal;
}

PositionDelays::PositionDelays(std::vector<machine::PositionDelay> const& unequal) {
  for (auto const& delay : unequal) {
    Axis axis;
    axis.waiting.assign(static_cast<std::size_t>(std::lround(delay.cycles)), 0);
    axis.share = 1 / (1 + delay.lag);
    axes_.push_back(std::move(axis));
  }
}

void PositionDelays::reset(Point const& position) {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    std::fill(axes_[i].waiting.begin(), axes_[i].waiting.end(), position[i]);
    axes_[i].value = position[i];
  }
}

void PositionDelays::step(Point& position) {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    Axis& axis = axes_[i];
    if (!axis.waiting.empty()) {
      std::swap(axis.waiting[axis.oldest], position[i]);
      axis.oldest = (axis.oldest + 1) % axis.waiting.size();
    }
    axis.value = axis.share == 1 ? position[i] : axis.value + axis.share * (position[i] - axis.value);
    position[i] = axis.value;
  }
}

}  // namespace axisc::motion
