// How long each axis of a machine is delayed, share by share: its position, and the velocity that is fed
// forward.
#pragma once

#include "axisc/answers/figures/plots.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct DelayShare {
  std::string name;
  double milliseconds = 0;
};

/// One way from the interpolator to the drive.
struct AxisDelay {
  std::string name;  ///< of the axis, or "X, v"
  std::vector<DelayShare> shares;
  double total = 0;
  std::optional<double> at_start = {};  ///< the total as long as no command switched the kernel on
};

/// A way to the drive in both states; none where there is no such state, or no such way in it.
struct DelayPair {
  std::optional<AxisDelay> was, is;
};

/// Of every axis its position, and its velocity where that is fed forward. What lies after the filters counts
/// where the machine is known.
[[nodiscard]] std::vector<DelayPair> delays_of(PlotSubject const& subject);

}  // namespace axisc
