// How fast an axis may be driven along its path, and how it moves from rest to rest: what its lists and the
// channel list say, as `simulate` plans it.
#pragma once

#include "analysis/motion/planning/axis_mode.hpp"
#include "analysis/motion/planning/single_axis.hpp"
#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// For a rotary axis ° stands for mm.
struct WantedMove {
  double distance_mm = 100;
  double feed_mm_per_min = 6000;
};

/// From rest to rest.
struct PlannedMove {
  std::vector<motion::Phase> phases;  ///< position units and cycles
  double seconds = 0;
  double velocity = 0;  ///< the highest: mm/s or °/s
};

class DrivenAxis {
 public:
  /// In a channel of the machine.
  DrivenAxis(machine::Machine const& machine, std::size_t axis, machine::MachineGroup const& channel);

  [[nodiscard]] machine::Slope slope() const { return path_.channel.slope; }
  /// False: no channel list says anything, and the control's defaults count.
  [[nodiscard]] bool has_channel_list() const { return path_.channel.is_from_list; }
  /// Parameters of the axis and the channel that change how the control plans, but nothing here:
  /// "P-AXIS-00202".
  [[nodiscard]] std::vector<std::string> const& uncomputed() const { return uncomputed_; }
  [[nodiscard]] PlannedMove feed(WantedMove const& move) const;
  [[nodiscard]] PlannedMove rapid(double distance_mm) const;
  /// Through a corner of 90° between this axis and one like it, mm/s or °/s.
  [[nodiscard]] double corner_velocity() const;
  /// What counts in feed blocks, or in G00, with the slope of the channel: units per cycle.
  [[nodiscard]] motion::AxisMode mode(bool rapid) const;

  [[nodiscard]] double seconds(double cycles) const { return cycles * path_.cycle_time.seconds(); }
  /// Units per cycle, per cycle² and per cycle³ in mm/s, mm/s² and m/s³, or the same of degrees.
  [[nodiscard]] double velocity(double value) const;
  [[nodiscard]] double acceleration(double value) const;
  [[nodiscard]] double jerk(double value) const;

 private:
  [[nodiscard]] PlannedMove planned(motion::SingleMove const& move) const;

  motion::PathDynamics path_;
  std::vector<std::string> uncomputed_;
};

/// In the first channel that has it, a gantry slave as its master; none for an axis that no channel moves, as
/// a spindle.
[[nodiscard]] std::optional<DrivenAxis> driven_axis(machine::Machine const& machine, std::size_t axis);

}  // namespace axisc
