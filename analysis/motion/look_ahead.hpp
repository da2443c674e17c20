// Path planning: blocks go in, phases of constant jerk come out.
//
// Without tolerance monitoring a block is handed on as soon as the control would begin it
// (velocity_window.hpp).
//
// With tolerance monitoring, and where the acceleration need not be 0 at the ends of blocks, more blocks are
// held and planned together. With monitoring a plan is changed until it keeps the tolerance, the stop at its
// end included. Only blocks that no later plan touches are handed on: those that end so long before the stop
// that neither its ramp nor a kernel reaches them. If no longer plan keeps the tolerance for them, the last
// one that did is driven to its end, where the path stops.
#pragma once

#include "analysis/motion/path_block.hpp"
#include "analysis/motion/planning/hsc_stretches.hpp"
#include "analysis/motion/planning/phase.hpp"
#include "analysis/motion/planning/velocity_window.hpp"
#include "analysis/motion/tolerance.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace axisc::motion {

/// How a block is passed; units per cycle.
struct BlockMotion {
  double velocity_in = 0, velocity_peak = 0, velocity_out = 0;
  LimitedBy limited_by = LimitedBy::feed;
};

/// Receives the planned path in its order.
class PathSink {
 public:
  virtual ~PathSink() = default;
  virtual void piece(PathBlock const& block, Phase const& phase) = 0;
  /// After the last piece of a block. `next` is null where the path stops.
  virtual void block_end(PathBlock const& block, PathBlock const* next, BlockMotion const& motion) = 0;
  /// The path rests at the end of a block where it stopped.
  virtual void rest(PathBlock const& block, std::uint64_t cycles) = 0;
  /// The path stopped at the end of a block, and waits until the axes are there.
  virtual void exact_stop(PathBlock const& block) = 0;
  /// At most this many more cycles are followed: a plan that takes longer is handed on without keeping the
  /// tolerance.
  [[nodiscard]] virtual double room() const = 0;

 protected:
  PathSink() = default;
  PathSink(PathSink const&) = default;
  PathSink& operator=(PathSink const&) = default;
};

class LookAhead {
 public:
  /// `constant_velocity`: neither ramps nor slower corners.
  LookAhead(PathLimits limits, bool constant_velocity, PathSink& sink);

  /// Applies to later blocks; the path is at rest. `monitor` may refer to answers that live as long as it is
  /// used.
  void begin(Point const& position, ToleranceMonitor monitor, double acceleration_factor);
  /// A block of length 0 is left out.
  void add(ProgrammedBlock const& block);
  /// The path stops after the last block.
  void stop();

 private:
  struct PlannedPiece {
    std::size_t block = 0;  ///< of those that are held
    Phase phase;
    bool ends_block = false;
    bool is_place = false;  ///< a plan may begin at its end
  };

  [[nodiscard]] double tolerated(Arc const& arc);
  [[nodiscard]] bool holds_blocks() const { return monitor_.active() || is_across_; }
  void pass_block();
  void collect_corners();
  [[nodiscard]] Corner corner_between(PathBlock const* before, PathBlock const* after, bool is_sharp) const;
  template <class Take>
  void for_each_plateau(Take take) const;
  void cut_into_elements();
  void limit_by_plateaus();
  void choose_velocities(bool ends);
  void take(PassedElement const& passed, std::vector<Phase> const& phases);
  void plan_stretches(bool ends);
  void plan_across(bool stops);
  void make_plan(bool ends);
  void forget();
  [[nodiscard]] bool is_too_long() const;
  void time_plan();
  void plan(bool stops);
  [[nodiscard]] bool keep_tolerance(bool ends);
  [[nodiscard]] std::size_t untouched_blocks() const;
  void hand_on(std::size_t count, bool stops);
  void drop_blocks(std::size_t count);
  void drive_kept_plan();
  void remember(std::size_t count);

  PathLimits limits_;
  bool constant_velocity_;
  PathSink& sink_;
  std::size_t window_;      ///< blocks that the control knows
  bool is_across_ = false;  ///< a block need not end with acceleration 0
  std::size_t full_ = 0;    ///< held blocks with which the next plan is made
  ToleranceMonitor monitor_;
  Point position_{};  ///< after the last block
  std::uint64_t next_index_ = 1;
  std::deque<PathBlock> blocks_;
  std::deque<PathElement> asked_;  ///< of each block
  PathBlock last_block_;           ///< the one before those that are held
  double velocity_ = 0;            ///< at the beginning of those that are held
  VelocityWindow velocities_;
  std::vector<Phase> phases_;

  // Where blocks are held:
  bool feasible_ = true;  ///< the plan begins with that velocity
  /// Those passed lately at places below 0, then the beginning of each block, then the end.
  std::vector<Corner> corners_;
  bool has_end_corner_ = false;
  std::size_t passed_corners_ = 0;
  std::vector<double> places_;  ///< where each block begins, and the end
  std::vector<double> cuts_;
  std::vector<PathElement> elements_;
  std::size_t slowed_for_stop_ = 0;  ///< the first element that the corner at the end slows down
  std::vector<PlannedPiece> pieces_;
  std::vector<BlockMotion> motions_;  ///< of each block
  std::size_t touched_ = 0;           ///< the first piece that more blocks would change
  std::size_t settled_blocks_ = 0;    ///< across the ends of blocks: those that are handed on
  std::vector<TimedPiece> path_;      ///< what was passed lately, then the plan
  std::size_t passed_pieces_ = 0;
  double time_ = 0;        ///< at the beginning of what is held, cycles
  double valid_from_ = 0;  ///< see TriedPath
  /// Of the last plan, what was not handed on.
  std::vector<PlannedPiece> kept_;
  std::vector<BlockMotion> kept_motions_;
};

}  // namespace axisc::motion
