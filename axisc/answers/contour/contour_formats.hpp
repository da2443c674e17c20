// Results of `axisc contour`, and their output formats.
#pragma once

#include "analysis/motion/contour/contour_predictions.hpp"
#include "diagnostics/message.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// One feed with one order.
struct ContourCase {
  double feed_mm_per_min = 0;
  std::optional<std::uint32_t> order;  ///< none: the lists'
  motion::ContourFigures corner, circle, line;
  double parallel = 0;
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
  std::vector<ContourCase> cases;  ///< by feed, then by order
  std::optional<ContourLimits> limits;
  bool synchronous = true;  ///< all axes have the same delay
};

struct ShownContour {
  double cycle_time_us = 0;
  double angle_deg = 90;
  double radius_mm = 10;
  std::vector<GroupContour> groups;
};

[[nodiscard]] std::string contour_text(ShownContour const& shown, Language language);
[[nodiscard]] std::string contour_csv(ShownContour const& shown);
[[nodiscard]] std::string contour_json(ShownContour const& shown);

}  // namespace axisc
