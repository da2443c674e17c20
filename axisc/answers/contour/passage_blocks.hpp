// What `contour` says of a corner as the control passes it.
#pragma once

#include "axisc/answers/contour/contour_groups.hpp"
#include "presentation/document.hpp"

#include <vector>

namespace axisc {

/// Of one feed: velocity through the corner, then time and way of braking and of accelerating.
[[nodiscard]] presentation::Row passage_figures(motion::CornerPassage const& passage,
                                                design::CycleTime cycle_time);
/// Their keys.
[[nodiscard]] std::vector<presentation::Column> passage_columns();

/// Velocity through the corner and ramps on either side for each feed, and why the control is that slow.
[[nodiscard]] std::vector<presentation::Block> passage_blocks(GroupContour const& group,
                                                              ContourRequest const& wanted);

}  // namespace axisc
