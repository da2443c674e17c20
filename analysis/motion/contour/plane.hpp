// The planes of a path: its first axis and another one, each of the others in turn.
#pragma once

#include "analysis/motion/contour/contour_predictions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace axisc::motion {

struct Plane {
  ChainAnswer const& first;
  ChainAnswer const& second;

  /// Cycles around a point of the path within which the chains remember it, at most.
  [[nodiscard]] double reach() const {
    return std::max(first.reach, second.reach) + std::abs(first.delay - second.delay) + 2;
  }
  [[nodiscard]] double latest() const { return std::max(first.delay, second.delay); }
};

/// The largest figures of the planes; `predict(plane, number)` gives those of one. A path of one axis has one
/// plane, as if a second axis were like it.
template <class Predict>
[[nodiscard]] ContourFigures over_planes(std::span<ChainAnswer const> answers, Predict predict) {
  if (answers.size() == 1) {
    return predict(Plane{.first = answers[0], .second = answers[0]}, std::size_t{0});
  }
  ContourFigures largest;
  for (std::size_t axis = 1; axis < answers.size(); ++axis) {
    ContourFigures const here = predict(Plane{.first = answers[0], .second = answers[axis]}, axis - 1);
    largest.deviation = std::max(largest.deviation, here.deviation);
    largest.axis_error[0] = std::max(largest.axis_error[0], here.axis_error[0]);
    largest.axis_error[axis] = here.axis_error[1];
  }
  return largest;
}

}  // namespace axisc::motion
