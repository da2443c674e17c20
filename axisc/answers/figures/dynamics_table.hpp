// What an axis may do along a path and how long a motion takes it, in numbers.
#pragma once

#include "axisc/answers/dynamics/driven_axis.hpp"
#include "diagnostics/wording.hpp"
#include "presentation/pictures/figure.hpp"

#include <string>
#include <vector>

namespace axisc {

/// An axis with a motion at feed and the same way in G00.
struct DynamicsRow {
  std::string axis;
  DrivenAxis driven;
  Wording feed;  ///< mm/min
  PlannedMove at_feed, in_rapid;
};

/// For each axis a row at feed and one in G00: acceleration and ramp times as they count with the slope of
/// the channel, the jerk a/tr of each ramp, the velocity that the motion reaches of the one that the axis
/// allows, the velocity through a corner of 90°, and the time; the slope where it is not that of all. Values
/// of braking stand behind those of accelerating where they differ. `unit` is "mm" or "°".
[[nodiscard]] pictures::Table dynamics_table(std::vector<DynamicsRow> const& rows, std::string const& unit,
                                             Language language);

}  // namespace axisc
