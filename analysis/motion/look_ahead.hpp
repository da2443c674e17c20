// Path planning with a trapezoidal velocity: blocks go in, pieces of constant acceleration and velocity limit
// come out.
//
// The planner holds a window of blocks within which the path can always stop: velocities are chosen backwards
// from rest at its end,  v_k² ≤ v_{k+1}² + 2 a L,  and forwards from the velocity that was reached. When the
// window is full, its first half is handed on.
//
// With tolerance monitoring a plan is changed until it keeps the tolerance, the stop at its end included.
// Only blocks that no later plan touches are handed on: those that end so long before the stop that neither
// its ramp nor a kernel reaches them. If no longer plan keeps the tolerance for them, the last one that did
// is driven to its end, where the path stops.
#pragma once

#include "analysis/motion/path_block.hpp"
#include "analysis/motion/tolerance.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace axisc::motion {

/// Receives the planned path in its order.
class PathSink {
 public:
  virtual ~PathSink() = default;
  virtual void piece(PathBlock const& block, PathPiece const& piece) = 0;
  /// After the last piece of a block. `next` is null where the path stops.
  virtual void block_end(PathBlock const& block, PathBlock const* next) = 0;
  /// The path rests at the end of a block where it stopped.
  virtual void rest(PathBlock const& block, std::uint64_t cycles) = 0;
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
  LookAhead(PathLimits limits, bool constant_velocity, PathSink& sink, std::size_t window = full_window)
      : limits_(std::move(limits)), constant_velocity_(constant_velocity), sink_(sink), window_(window) {}

  /// Applies to later blocks; the path is at rest. `monitor` may refer to answers that live as long as it is
  /// used.
  void begin(Point const& position, ToleranceMonitor monitor, double acceleration_factor);
  /// A block of length 0 is left out.
  void add(ProgrammedBlock const& block);
  /// The path stops after the last block.
  void stop();

  static constexpr std::size_t full_window = 2048;  ///< blocks

 private:
  struct Stretch {
    std::size_t block = 0;  ///< of the window
    PathPiece piece;
    bool ends_block = false;
  };

  [[nodiscard]] double tolerated(Arc const& arc);
  void collect_corners();
  [[nodiscard]] Corner corner_between(PathBlock const* before, PathBlock const* after, bool is_sharp) const;
  template <class Take>
  void for_each_plateau(Take take) const;
  void cut_into_stretches();
  void limit_by_plateaus();
  [[nodiscard]] bool choose_velocities();
  void make_plan();
  void forget();
  [[nodiscard]] bool is_too_long() const;
  void time_plan();
  void plan(bool stops);
  [[nodiscard]] bool keep_tolerance();
  [[nodiscard]] std::size_t untouched_blocks() const;
  void hand_on(std::size_t count, bool stops);
  void drive_kept_plan();
  void remember(std::size_t count);

  PathLimits limits_;
  bool constant_velocity_;
  PathSink& sink_;
  std::size_t window_;
  std::size_t full_ = 0;  ///< blocks with which the next plan is made
  ToleranceMonitor monitor_;
  double acceleration_factor_ = 1;
  Point position_{};  ///< after the last block
  std::uint64_t next_index_ = 1;
  std::deque<PathBlock> blocks_;
  PathBlock last_block_;  ///< the one before the window
  double velocity_ = 0;   ///< at the beginning of the window
  bool feasible_ = true;  ///< the plan begins with that velocity
  /// Those passed lately at places below 0, then the beginning of each block, then the end.
  std::vector<Corner> corners_;
  bool has_end_corner_ = false;
  std::size_t passed_corners_ = 0;
  std::vector<double> places_;  ///< where each block of the window begins, and the end
  std::vector<double> cuts_;
  std::vector<Stretch> stretches_;
  std::vector<double> velocities_;  ///< before each stretch, and at the end
  std::size_t touched_ = 0;         ///< the first stretch that the stop at the end slows down

  // With tolerance monitoring:
  std::vector<TimedPiece> path_;  ///< what was passed lately, then the plan
  std::size_t passed_pieces_ = 0;
  double time_ = 0;            ///< at the beginning of the window, cycles
  double valid_from_ = 0;      ///< see TriedPath
  std::vector<Stretch> kept_;  ///< of the last plan that kept the tolerance, what was not handed on
  std::size_t kept_blocks_ = 0;
};

}  // namespace axisc::motion
