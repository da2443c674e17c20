// A real-time list: the NC cycle time. Parameters P-RTCF.
#pragma once

#include "configuration/located_text.hpp"
#include "design/units.hpp"

#include <optional>

namespace axisc::configuration {

struct RealTimeList {
  std::optional<design::CycleTime> cycle_time;  ///< none where the control is scheduled from outside
  Place place;                                  ///< of the number that gives it
};

/// The cycle of the thread that runs `task_int` (thread[i].cycle), else cycle_time; both in µs.
[[nodiscard]] RealTimeList read_real_time_list(SourceText const& text, SourceId source);

}  // namespace axisc::configuration
