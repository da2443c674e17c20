// A real-time list: the NC cycle time. Parameters P-RTCF.
#pragma once

#include "configuration/located_text.hpp"
#include "design/units.hpp"
#include "diagnostics/finding.hpp"

#include <cstdint>
#include <deque>
#include <optional>

namespace axisc::configuration {

/// None where no control runs with a cycle of this many nanoseconds.
[[nodiscard]] constexpr std::optional<design::CycleTime> possible_cycle_time(std::uint64_t nanoseconds) {
  if (nanoseconds > design::longest_cycle_time.nanoseconds) return std::nullopt;
  design::CycleTime const time{static_cast<std::uint32_t>(nanoseconds)};
  return design::is_possible(time) ? std::optional(time) : std::nullopt;
}

struct RealTimeList {
  std::optional<design::CycleTime> cycle_time;  ///< none where the control is scheduled from outside
  Place place;                                  ///< of the number that gives it
};

/// The cycle of the thread that runs `task_int` (thread[i].cycle), else cycle_time; both in µs. One that no
/// control runs with becomes an AX4020 finding (place and sentence).
[[nodiscard]] RealTimeList read_real_time_list(SourceText const& text, SourceId source,
                                               std::deque<Finding>& findings);

}  // namespace axisc::configuration
