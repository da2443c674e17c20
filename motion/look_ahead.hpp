// Path planning with a trapezoidal velocity: blocks go in, pieces of constant acceleration and velocity limit come out.
//
// The planner holds a window of blocks within which the path can always stop: velocities are chosen backwards from rest at
// its end,  v_k² ≤ v_{k+1}² + 2 a L,  and forwards from the velocity that was reached. Of a full window the first half is
// handed on.
#pragma once

#include "motion/path_block.hpp"
#include "motion/tolerance.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace axisc::motion {

/// A stretch of one block: from one velocity to another, in between as fast as limit and acceleration allow.
struct PathPiece {
  double length = 0;  ///< position units
  double velocity_in = 0, velocity_out = 0, velocity_limit = 0;
  double acceleration = 0;
};

/// Receives the planned path in its order.
class PathSink {
 public:
  virtual ~PathSink() = default;
  virtual void piece(PathBlock const& block, PathPiece const& piece) = 0;
  /// Behind the last piece of a block. `next` is null where the path stops.
  virtual void block_end(PathBlock const& block, PathBlock const* next) = 0;

 protected:
  PathSink() = default;
  PathSink(PathSink const&) = default;
  PathSink& operator=(PathSink const&) = default;
};

class LookAhead {
 public:
  /// `constant_velocity`: neither ramps nor slower corners.
  LookAhead(PathLimits limits, bool constant_velocity, PathSink& sink)
      : limits_(std::move(limits)), constant_velocity_(constant_velocity), sink_(sink) {}

  /// For the blocks to come; the path stands. `monitor` may refer to answers that live as long as it is used.
  void begin(Point const& position, ToleranceMonitor monitor, double acceleration_factor);
  /// A block of length 0 is left out.
  void add(ProgrammedBlock const& block);
  /// The path stops behind the last block.
  void stop();

  static constexpr std::size_t window = 2048;  ///< blocks

 private:
  struct Stretch {
    std::size_t block = 0;  ///< of the window
    PathPiece piece;
    bool ends_block = false;
  };

  void collect_corners();
  void cut_into_stretches();
  void limit_by_plateaus();
  void choose_velocities();
  void plan(std::size_t handed_on, bool stops);
  void remember_corners(double passed);

  PathLimits limits_;
  bool constant_velocity_;
  PathSink& sink_;
  ToleranceMonitor monitor_;
  double acceleration_factor_ = 1;
  Point position_{};  ///< behind the last block
  std::uint64_t next_index_ = 0;
  std::deque<PathBlock> blocks_;
  PathBlock last_block_;         ///< the one before the window
  double velocity_ = 0;          ///< at the beginning of the window
  std::vector<Corner> corners_;  ///< those passed lately at places below 0, then those of the window
  std::size_t passed_corners_ = 0;
  std::vector<double> places_;  ///< where each block of the window begins, and the end
  std::vector<double> cuts_;
  std::vector<Stretch> stretches_;
  std::vector<double> velocities_;  ///< before each stretch, and at the end
};

}  // namespace axisc::motion
