// The circular test: what a machine's filters make of a circle, and what a recording shows of it.
#pragma once

#include "analysis/circle/predicted_circle.hpp"
#include "axisc/answers/circle/filtered_axis.hpp"
#include "axisc/answers/circle/recorded_circle.hpp"
#include "axisc/checking/path_machine.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

struct CircleQuestion {
  MachineRequest machine;
  std::optional<std::string> plane;    ///< "XY" or "X,Y"; none: the recorded one, or each pair of linear axes
  std::vector<double> feeds;           ///< mm/min; with a recording none, or one that is its feed
  std::optional<double> radius_mm;     ///< with a recording none, or its radius
  std::optional<double> tolerance_um;  ///< of G, or G(b)
  std::vector<std::string> recordings;
  RecordedCircleQuestion recorded;
};

/// One plane, feed and radius.
struct CircleCase {
  std::array<std::string, 2> axes;  ///< u, v
  double feed_mm_per_min = 0, radius_mm = 0;
  std::array<FilteredAxis, 2> filtered;
  circle::PredictedCircle predicted;
  circle::Deviations deviations;  ///< predicted
  std::optional<RecordedCircle> recorded;

  /// τ_u - τ_v, predicted.
  [[nodiscard]] double delay_difference_s() const;
  /// G(b), or of one direction G: recorded, without a recording predicted.
  [[nodiscard]] double deviation() const;
};

struct CircularTest {
  design::CycleTime cycle_time;
  std::vector<CircleCase> cases;  ///< by plane, then by feed
  std::optional<double> tolerance_um;
  std::vector<std::string> files;  ///< that were read

  [[nodiscard]] bool keeps(CircleCase const& one) const;
  [[nodiscard]] bool keeps_tolerance() const;
};

/// What the check of a machine is told whose circles are asked for: axes that are out of step (AX4011) are
/// no error, because the test shows what they do.
[[nodiscard]] Overrides with_unlike_delays(Overrides overrides);

/// Predicted, of each pair of linear axes of a channel; without cases where it lacks two. Failure as for
/// circular_test().
[[nodiscard]] CircularTest channel_circles(CircleMachine const& machine, std::size_t group, double feed,
                                           double radius_mm);

/// None after other errors. Failure where feed or radius are missing or not those of the recording, where the
/// machine lacks two linear axes, and for what the recording lacks.
[[nodiscard]] std::optional<CircularTest> circular_test(Workspace& workspace, CircleQuestion const& question,
                                                        ErrorSink const& errors);

}  // namespace axisc
