// What an axis may do along a path and how long a motion takes it, in numbers.
#pragma once

#include "axisc/answers/dynamics/driven_axis.hpp"
#include "diagnostics/wording.hpp"
#include "presentation/pictures/figure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// An axis with a motion at feed and the same way in G00.
struct DrivenState {
  DrivenAxis driven;
  PlannedMove at_feed, in_rapid;
};

struct DynamicsRows {
  std::string axis;
  std::string unit;  ///< "mm", "°"
  std::optional<DrivenState> before;
  DrivenState now;
};

/// How the table names its columns.
struct DynamicsTerms {
  Wording feed;  ///< mm/min
  bool has_before = false;
  Language language = Language::english;
};

/// For each axis the slope, accelerations and ramp times as they count with it, the jerk a/tr, the velocity
/// that the axis allows and the one that the motion reaches, the velocity through a corner of 90°, and the
/// time; in columns at feed and in G00, as before and as now. Quantities that are the same have one row, as
/// the four ramp times; what a slope does not have is left out.
[[nodiscard]] pictures::Table dynamics_table(std::vector<DynamicsRows> const& axes,
                                             DynamicsTerms const& terms);

}  // namespace axisc
