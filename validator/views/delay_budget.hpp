// What delays the position of an axis, and what delays the quantities that are fed forward: both reach the
// drive on their own path, and what does not arrive together becomes a deviation.
#pragma once

#include "configuration/machine/drive_path.hpp"
#include "validator/loading/loading.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::validator {

/// What the program has switched.
enum class DelayState : std::uint8_t {
  at_start,     ///< nothing: feedforward as P-AXIS-00255 says, filters as `filter_fir.enable` says
  fed_forward,  ///< G135
  filters_on,   ///< `#FILTER ON` or `#VIB GUARD ON`
};

using machine::DelayKind;

/// In NC cycles; 0 on the paths that it does not delay.
struct DelayItem {
  DelayKind kind{};
  std::string filter = {};                ///< of DelayKind::filter: `filter[0]`
  EffectiveValue const* cause = nullptr;  ///< its parameter, valid while the EffectiveValues live; null: none
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;
  bool is_reading = false;  ///< inferred, not documented
};

struct DelayBudget {
  std::vector<DelayItem> items;  ///< those that are not 0, on the way to the drive
  bool feeds_forward = false;    ///< otherwise nothing is on the other path, and its sums mean nothing
  bool feeds_velocity = false;   ///< otherwise there is no lead
  double position = 0;           ///< with the lag
  double lag = 0;                ///< of the position controller
  bool has_filter_off = false;   ///< DelayState::filters_on delays more
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;

  /// Positive: the velocity reaches the drive before the position that belongs to it. The lag arises behind
  /// it and does not count. 0 where the velocity is not fed forward.
  [[nodiscard]] double lead() const { return feeds_velocity ? position - lag - velocity : 0; }
};

/// None if a filter cannot be designed: its delay is then unknown. Where the drive type is not stated, what
/// needs one counts as absent. Cost: one design per active filter.
[[nodiscard]] std::optional<DelayBudget> delay_budget(LoadedAxis const& axis, design::CycleTime cycle_time,
                                                      DelayState state = DelayState::at_start);

/// At the start of programs: what delays the position after the filters on its way to the drive, in cycles.
[[nodiscard]] double delay_after_filters(LoadedAxis const& axis, design::CycleTime cycle_time);

/// What delays position and velocity after the filters.
[[nodiscard]] machine::DrivePath drive_path(LoadedAxis const& axis, design::CycleTime cycle_time,
                                            DelayState state);

/// The largest deviation of a straight line or a circle between two axes, in µm: F ΔP/2 at 45°. `feed` in
/// µm/s, `mismatch` in cycles.
[[nodiscard]] double deviation_of_mismatch(double feed, double mismatch, design::CycleTime cycle_time);
/// How far a lead of the velocity takes an axis ahead while it accelerates, in µm: a L/Kv. None where the
/// position is not controlled in the NC, or no list gives its gain; a gain by default says nothing.
[[nodiscard]] std::optional<double> deviation_of_lead(LoadedAxis const& axis, double lead,
                                                      design::CycleTime cycle_time);
/// Of the linear axes of a channel, µm/s: P-AXIS-00212. None without a usable one.
[[nodiscard]] std::optional<double> lowest_velocity_limit(LoadedMachine const& machine,
                                                          LoadedGroup const& group);

}  // namespace axisc::validator
