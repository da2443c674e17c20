// Tolerance monitoring (AX_DEV): how fast corners and curvature may be passed.
//
// Nothing is assumed of a path: it is planned, tried (path_trial.hpp), slowed down around the corners whose surroundings
// exceed the tolerance, planned and tried again, until none does. So a corner never relies on another one that a slower
// path moves out of reach, and nothing is slower that keeps the tolerance anyway. A slow corner's velocity holds on a plateau
// of h cycles to either side, where its kernels' R is 0, and one cycle more, because setpoints on either side of a corner may
// lie away from it.
#pragma once

#include "motion/path_trial.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace axisc::motion {

/// The beginning of a block, and how fast the path may be around it.
struct Corner {
  double place = 0;    ///< along the path, units
  bool turns = false;  ///< the direction changes
  double fastest = 0;  ///< most that the blocks beside it allow, units per cycle
  double velocity = std::numeric_limits<double>::infinity();  ///< of its plateau; infinite: none
  bool wide = false;  ///< the plateau covers everything that is nearer to this corner than to others

  bool passed = false;  ///< the machine is beyond it
  double time = 0;      ///< when the path planned last passes it, cycles
  /// What was tried last, and its result.
  std::uint64_t tried_path = 0;
  bool proved = false;  ///< at the time at which the machine will pass it
  double phase = 0;     ///< of that time in its cycle
  double error = 0, tried_velocity = 0, tried_fastest = 0;
  /// How the velocity was searched.
  double kept = 0, exceeded = std::numeric_limits<double>::infinity();
  double error_before = 0, velocity_before = 0;
  int lowered = 0, raised = 0;
};

struct TriedPath {
  std::span<TimedPiece const> pieces;
  /// Points from here on can be tried: the beginning of a path that begins at rest, otherwise cycles_before() after it.
  double valid_from = 0;
};

class ToleranceMonitor {
 public:
  /// Monitors nothing.
  ToleranceMonitor() = default;
  /// `tolerance` in units; 0: no monitoring. Runtime and answers live longer.
  ToleranceMonitor(GroupRuntime& probe, std::vector<ChainAnswer> const& answers, double tolerance);

  [[nodiscard]] bool active() const { return trial_ != nullptr; }
  /// Cycles on either side of a corner.
  [[nodiscard]] double plateau() const { return plateau_; }
  /// Cycles around a point of the path within which another plan changes what is measured there.
  [[nodiscard]] double cycles_before() const { return trial_->cycles_before(); }
  [[nodiscard]] double cycles_after() const { return trial_->cycles_after(); }

  /// Largest velocity on a circle of this radius that keeps the tolerance however long it lasts.
  [[nodiscard]] double velocity_on(double radius) const;

  /// What to do with a plan.
  enum class Verdict : std::uint8_t {
    keeps,    ///< the tolerance everywhere
    changed,  ///< velocities of corners: plan once more
    fails,    ///< where it can no longer be mended, because the machine has passed it or cannot brake for it
  };
  /// Tries a plan where it is new, and changes the velocities of corners; `round` counts the plans of this path from 0.
  /// Cost: that of simulating the surroundings of new or changed corners.
  [[nodiscard]] Verdict judge(TriedPath const& path, std::span<Corner> corners, int round);

 private:
  void sign(TriedPath const& path, std::span<Corner const> corners);
  enum class Trial : std::uint8_t {
    search,  ///< of what is new, at setpoints and corners
    proof,   ///< of everything, also between them
  };
  void measure(TriedPath const& path, std::span<Corner> corners, Trial trial);
  [[nodiscard]] bool adjust(std::span<Corner> corners, double limit, bool raises) const;
  void lower(Corner& corner) const;
  [[nodiscard]] bool raise(std::span<Corner> corners, std::size_t cell) const;
  /// The largest error of the corners that a plateau of this one covers.
  [[nodiscard]] double largest_around(std::span<Corner const> corners, std::size_t cell) const;

  std::unique_ptr<PathTrial> trial_;
  double tolerance_ = 0;
  double plateau_ = 0;
  std::vector<std::size_t> cells_;         ///< corners that points of the path are counted to
  std::vector<std::uint64_t> sums_;        ///< of the pieces' digests
  std::vector<std::uint64_t> signatures_;  ///< of the cells' surroundings
  std::vector<TriedCorner> tried_;         ///< cells
  bool unproved_ = false;                  ///< the proof ended early
  bool proving_ = false;                   ///< velocities have been found: they are only lowered
  std::vector<char> wanted_;               ///< cells
};

}  // namespace axisc::motion
