// Lets the runtime pass a planned path before the machine does, and measures how far each corner's
// surroundings bend.
//
// Setpoints are those that the interpolator will give: the path's times count from its beginning, whole ones
// are NC cycles.
#pragma once

#include "analysis/motion/contour/contour_meter.hpp"
#include "analysis/motion/group_runtime.hpp"
#include "analysis/motion/planning/phase.hpp"
#include "analysis/motion/segment.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace axisc::motion {

/// A stretch of a planned path.
struct TimedPiece {
  Segment path;
  double from = 0;    ///< along the path, position units
  double length = 0;  ///< position units
  Phase phase;
  double place = 0;     ///< of its beginning along the path, position units
  double start = 0;     ///< cycles
  double duration = 0;  ///< cycles
  bool ends_block = false;

  [[nodiscard]] double end() const { return start + duration; }
  /// This far after its beginning.
  [[nodiscard]] Point at(double way) const { return path.at(from + way); }
};

/// A corner, to which the points of the path are counted that are nearest to it along the path.
struct TriedCorner {
  double place = 0;                       ///< position units
  double time = 0;                        ///< cycles
  bool whole = false;                     ///< points beyond the kernels' reach count apart
  double error = 0;                       ///< the largest axis error found, position units
  double fastest = 0;                     ///< path velocity within the kernels' reach, units per cycle
  double far_error = 0, far_fastest = 0;  ///< the same beyond it
};

/// The part of a path to measure.
struct TrialSpan {
  double from = 0, to = 0;  ///< cycles
  double phase = 0;         ///< setpoints come this much after whole cycles, 0..1
  /// A tolerance: measured also between setpoints and corners, more closely where errors come near it.
  std::optional<double> proves = std::nullopt;
};

class PathTrial final : private MeasuredSink {
 public:
  /// Both must outlive this; the runtime is switched as `answers` say, and will be reset again and again.
  /// `working` is called every millisecond or so.
  PathTrial(GroupRuntime& runtime, std::span<ChainAnswer const> answers, std::function<void()> working);

  /// Cycles before and after a point of the path within which setpoints affect the measurement there.
  [[nodiscard]] double cycles_before() const { return 2 * reach_ + spread_ + 3; }
  [[nodiscard]] double cycles_after() const { return latest_ + reach_ + 3; }
  /// Cycles on either side of a corner beyond which nothing is left of it.
  [[nodiscard]] double reach() const { return reach_ + spread_ + 1; }
  [[nodiscard]] std::span<ChainAnswer const> answers() const { return answers_; }
  /// All axes have the same chain: what lies straight stays straight.
  [[nodiscard]] bool alike() const { return alike_; }

  /// Measures a span of the path and raises the figures of their corners. The path rests after its end, and
  /// before its beginning, too, unless it lies cycles_before() ahead of it. Cost: as for a simulation of
  /// these cycles.
  void run(std::span<TimedPiece const> path, std::span<TriedCorner> corners, TrialSpan const& span);

 private:
  /// A point of the path that was passed to the meter.
  struct Looked {
    TimedPiece const* piece = nullptr;
    double way = 0;

    [[nodiscard]] double place() const { return piece->place + way; }
  };
  /// A measured place on a block.
  struct Sample {
    double along = 0;
    double error = 0;
  };

  void measured(MeasuredPoint const& point) override;
  double take(MeasuredPoint const& point);
  void look_between(MeasuredPoint const& point, Segment const& block, Sample const& a, Sample const& b,
                    int halvings_left);
  [[nodiscard]] bool is_near(TriedCorner const& corner, double time) const;

  GroupRuntime* runtime_;
  std::span<ChainAnswer const> answers_;
  ContourMeter meter_;
  std::span<TriedCorner> corners_;
  std::function<void()> working_;
  std::deque<Looked> pending_;  ///< not measured yet
  std::optional<double> proves_;
  std::optional<Looked> before_;  ///< the point measured last
  double error_before_ = 0;
  double time_of_first_ = 0;  ///< of the meter's first setpoint, cycles of the path
  double reach_ = 0, spread_ = 0, latest_ = 0;
  bool alike_ = true;
};

}  // namespace axisc::motion
