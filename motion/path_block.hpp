// The straight blocks of a path, as a program asks for them and as the axes allow them.
#pragma once

#include "motion/point.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace axisc::motion {

/// What one block of a program asks for.
struct ProgrammedBlock {
  Point end{};                                            ///< position units
  double feed = std::numeric_limits<double>::infinity();  ///< units per cycle; infinite for G00
  std::uint32_t line = 0;                                 ///< of the program, from 1
  std::string label;                                      ///< "N040"; empty for a block without number
};

/// The same with what the axes allow.
struct PathBlock {
  Point begin{}, end{};
  Point direction{};        ///< unit vector
  double length = 0;        ///< position units
  double velocity = 0;      ///< most that feed and axes allow, units per cycle
  double acceleration = 0;  ///< along the path, units per cycle²
  std::uint64_t index = 0;  ///< among the blocks that move
  std::uint32_t line = 0;
  std::string label;
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
  /// Largest velocity, and acceleration, in a direction at which no axis exceeds its own:  min limit_i / |u_i|.
  [[nodiscard]] double velocity(Point const& direction) const;
  [[nodiscard]] double acceleration(Point const& direction) const;
  /// Largest path velocity through a corner where the direction changes by `turn`. The velocity of no axis may change by
  /// more, from one cycle to the next, than
  ///     Δv_i = a_max,i T (1 + w_i f),
  /// w_i P-AXIS-00013 as a share, f the factor ACC_FACT, which counts while the filter is on.
  [[nodiscard]] double corner(Point const& turn, double acceleration_factor) const;

 private:
  std::vector<AxisLimits> axes_;
};

}  // namespace axisc::motion
