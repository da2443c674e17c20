// A recording of a circle, read for the axes of a plane.
#pragma once

#include "analysis/circle/causes.hpp"
#include "analysis/circle/deviations.hpp"
#include "analysis/circle/turn.hpp"
#include "axisc/answers/circle/circle_columns.hpp"
#include "axisc/answers/execution/recorded_scale.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct RecordedCircleQuestion {
  std::vector<std::string> files;
  std::vector<AxisColumn> setpoints, actuals;  ///< that options name
  PositionUnits units = {};
  bool is_external = false;         ///< columns angle_deg, deviation_um of a measuring instrument
  std::optional<double> radius_mm;  ///< of a recording without setpoints
  std::optional<double> feed;       ///< mm/min, of a recording without times
};

/// What ρ is measured from.
enum class CircleReference : std::uint8_t {
  setpoint,           ///< before the filters, or as an option or a name says
  filtered_setpoint,  ///< after them: what they do is not in the figures
  least_squares,      ///< there are no setpoints
};

struct RecordedCircle {
  std::vector<circle::Turn> turns;  ///< about their centre; one, or two in different directions
  CircleReference reference = CircleReference::setpoint;
  bool is_external = false;
  double radius = 0;         ///< R, µm
  double angular_speed = 0;  ///< rad/s
  std::size_t points = 0;    ///< of the turn that has the fewest
  circle::Deviations deviations;
  std::optional<circle::Causes> causes;  ///< of two directions
  std::vector<std::string> signals;      ///< of `mapping`: "X setpoint"
  std::vector<MappedColumn> mapping;

  [[nodiscard]] double feed_mm_per_min() const;
};

/// `settling_s` is the time after which the filters have forgotten how the circle began. Failure (AX9005)
/// with its place for a recording that has no turn that counts.
[[nodiscard]] RecordedCircle recorded_circle(CircleMachine const& machine, Plane const& plane,
                                             std::vector<RecordingFile> const& files,
                                             RecordedCircleQuestion const& question, double settling_s);

}  // namespace axisc
