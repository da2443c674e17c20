// The predictions of `axisc contour` for one group of axes.
#pragma once

#include "axisc/answers/contour/contour_formats.hpp"
#include "configuration/machine/machine.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// What to predict, from the command line.
struct ContourRequest {
  std::vector<double> feeds = {1000};
  std::vector<std::optional<std::uint32_t>> orders = {std::nullopt};
  double angle_deg = 90;
  double radius_mm = 10;
  std::optional<double> tolerance_mm;
};

/// A group with its filters switched by these commands.
struct ContourGroup {
  machine::Machine const& machine;
  std::size_t group = 0;
  std::vector<machine::FilterCommand> commands;
  std::string path;  ///< of the machine, for messages
};

/// Failure for a group whose axes cannot follow a path.
[[nodiscard]] GroupContour predict_contour(ContourGroup const& group, ContourRequest const& wanted);

}  // namespace axisc
