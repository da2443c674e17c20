// The blocks of a path, as a program asks for them and as the axes allow them.
#pragma once

#include "analysis/motion/block_dynamics.hpp"
#include "analysis/motion/limited_by.hpp"
#include "analysis/motion/planning/axis_mode.hpp"
#include "analysis/motion/planning/ramp.hpp"
#include "analysis/motion/segment.hpp"

#include <cstdint>
#include <limits>
#include <memory>
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
  double length = 0;           ///< position units
  double velocity = 0;         ///< most that feed and axes allow, units per cycle
  double velocity_within = 0;  ///< most that the axes allow, whatever the feed: where braking for it is late
  LimitedBy velocity_cause = LimitedBy::feed;
  Ramp up, down;  ///< changes of the velocity along the path
  std::shared_ptr<BlockMode const> mode;
  bool rapid = false;
  bool brakes_late = false;
  std::uint64_t index = 0;  ///< among the blocks that move, from 1
  std::uint32_t line = 0;
  std::string label;

  /// Unit vectors where it begins and ends.
  [[nodiscard]] Point direction_in() const { return path.direction_at(0); }
  [[nodiscard]] Point direction_out() const { return path.direction_at(length); }
};

/// What the axes allow along a path.
///
/// In a direction u no axis exceeds its own:
///     v ≤ v_i / |u_i|,  a = min a_i / |u_i|,  jerk = min (a_i / tr_i) / |u_i|,
/// separately for each of the four ramps, whose times along the path are a / jerk. With STEP a(v) takes the
/// stage of each axis at |u_i| v.
///
/// On an arc, with ρ = r / share² and the weaker axis, direction and stage of its plane,
///     v² ≤ a ρ / √2,  v³ / ρ² ≤ a / tr_geom (not STEP),
/// and along it  a_t² = a² - (v² / ρ)²  with unchanged ramp times.
class PathLimits {
 public:
  explicit PathLimits(PathDynamics dynamics) : dynamics_(std::move(dynamics)) {}

  [[nodiscard]] std::size_t axis_count() const { return dynamics_.axes.size(); }
  [[nodiscard]] PathDynamics const& dynamics() const { return dynamics_; }
  /// ACC_FACT, from the next block on.
  void set_acceleration_factor(double factor);
  /// The block from `position`, without index. `most` is a velocity that other causes give; `begins_faster`
  /// where the block before brakes late.
  [[nodiscard]] PathBlock block(ProgrammedBlock const& asked, Point const& position, double length,
                                double most, bool begins_faster);

 private:
  [[nodiscard]] std::shared_ptr<BlockMode const> mode_of(ProgrammedBlock const& block);

  PathDynamics dynamics_;
  double acceleration_factor_ = 1;
  /// Of the last block, at feed and in G00.
  struct Known {
    std::shared_ptr<BlockDynamics const> words;
    std::shared_ptr<BlockMode const> mode;
  };
  Known feed_, rapid_;
};

}  // namespace axisc::motion
