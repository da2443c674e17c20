// The blocks of a path, as a program asks for them and as the axes allow them.
#pragma once

#include "analysis/motion/block_dynamics.hpp"
#include "analysis/motion/segment.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace axisc::motion {

/// One block of a program.
struct ProgrammedBlock {
  Point end{};                                            ///< position units
  double feed = std::numeric_limits<double>::infinity();  ///< units per cycle; infinite for G00
  bool rapid = false;                                     ///< G00: velocity and accelerations of its own
  bool exact_stop = false;                                ///< at its end: G60, G360, P-CHAN-00235 after G00
  bool brakes_late = false;  ///< for the next feed only after its end: G901, unless G09 is in the block
  /// Null: nothing was said; the slope is that of the channel, and values are those of the lists.
  std::shared_ptr<BlockDynamics const> dynamics;
  std::shared_ptr<Arc const> arc;  ///< null for a straight line
  std::uint32_t line = 0;          ///< of the program, from 1
  std::string label;               ///< "N040"; empty for a block without number
};

/// A programmed block with the limits of the axes.
struct PathBlock {
  Segment path;
  Point end{};
  double length = 0;        ///< position units
  double velocity = 0;      ///< most that feed and axes allow, units per cycle
  double acceleration = 0;  ///< along the path, the mean of a ramp, units per cycle²
  bool smooth = false;      ///< sin²
  std::uint64_t index = 0;  ///< among the blocks that move, from 1
  std::uint32_t line = 0;
  std::string label;

  /// Unit vectors where it begins and ends.
  [[nodiscard]] Point direction_in() const { return path.direction_at(0); }
  [[nodiscard]] Point direction_out() const { return path.direction_at(length); }
};

/// Limits of one axis, from vb_max, a_max and a_trans_weight.
struct AxisLimits {
  double velocity = 0;           ///< units per cycle
  double acceleration = 0;       ///< units per cycle²
  double transition_weight = 0;  ///< P-AXIS-00013 as a share, 0..1
};

/// Limits of the axes along a path.
class PathLimits {
 public:
  explicit PathLimits(std::vector<AxisLimits> axes) : axes_(std::move(axes)) {}

  [[nodiscard]] std::size_t axis_count() const { return axes_.size(); }
  /// Largest velocity, and acceleration, in a direction at which no axis exceeds its own:  min limit_i /
  /// |u_i|.
  [[nodiscard]] double velocity(Point const& direction) const;
  [[nodiscard]] double acceleration(Point const& direction) const;
  /// Largest velocity, and acceleration, on an arc, whichever way it points: no axis of its plane accelerates
  /// along and across the path together by more than the weaker one can, of which the way across takes at
  /// most 1/√2:
  ///     v² ≤ a ρ / √2,  a_t² = a² - (v² / ρ)².
  [[nodiscard]] double velocity(Segment const& arc) const;
  [[nodiscard]] double acceleration(Segment const& arc, double velocity) const;
  /// Largest path velocity through a corner where the direction changes by `turn`. The velocity of no axis
  /// may change by more, from one cycle to the next, than
  ///     Δv_i = a_max,i T (1 + w_i f),
  /// w_i P-AXIS-00013 as a share, f the factor ACC_FACT, which counts while the filter is on.
  [[nodiscard]] double corner(Point const& turn, double acceleration_factor) const;

 private:
  std::vector<AxisLimits> axes_;
};

}  // namespace axisc::motion
