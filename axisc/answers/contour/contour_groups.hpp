// The predictions of `axisc contour` for one group of axes.
#pragma once

#include "analysis/motion/contour/contour_predictions.hpp"
#include "analysis/motion/contour/corner_passage.hpp"
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
  bool tries_orders = true;  ///< with a tolerance also looks for the largest order, which takes seconds
};

/// One feed with one order.
struct ContourCase {
  double feed_mm_per_min = 0;
  std::optional<std::uint32_t> order;  ///< none: the lists'
  motion::ContourFigures corner, circle, line;
  double parallel = 0;
  /// The corner as the control passes it; none where a filter reaches too far (motion::predict_passage).
  std::optional<motion::ContourFigures> passed_corner;
};

/// How the control passes the corner, in the plane in which it is slowest.
struct PassedFeed {
  double feed_mm_per_min = 0;
  motion::CornerPassage passage;
};

/// Feeds and orders that keep the tolerance.
struct ContourLimits {
  double tolerance_mm = 0;
  std::optional<double> corner_feed, circle_feed;  ///< mm/min; none: any
  std::optional<std::uint32_t> order;              ///< at the first feed; none: not one
  bool has_order = false;                          ///< an order can be commanded
};

struct GroupContour {
  std::string name;
  std::vector<std::string> axes;
  std::vector<ContourCase> cases;    ///< by feed, then by order
  std::vector<PassedFeed> passages;  ///< by feed
  motion::PathDynamics dynamics;     ///< with which the control passes the corner
  double acceleration_factor = 1;    ///< ACC_FACT
  std::optional<ContourLimits> limits;
  bool synchronous = true;                                   ///< all axes have the same delay
  std::vector<machine::PositionDelay> position_delays = {};  ///< after the filters, of each axis
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
