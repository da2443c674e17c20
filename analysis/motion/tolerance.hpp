// Tolerance monitoring (AX_DEV): how fast corners and curvature may be passed.
//
// Nothing is assumed of a path: it is planned, tried (path_trial.hpp), slowed down around the corners whose
// surroundings exceed the tolerance, planned and tried again, until none does. So a corner never relies on
// another one that a slower path moves out of reach, and nothing is slower that keeps the tolerance anyway. A
// slow corner's velocity holds on a plateau of h cycles to either side, where its kernels' R is 0, and one
// cycle more, because setpoints on either side of a corner may lie away from it. Beyond that reach an arc is
// bent, and axes that are out of step leave straight lines: there another velocity is found, for all that is
// nearer to this corner than to others.
//
// This terminates, and the tolerance is kept. Let b_k be a chain's answer to an impulse, Σ b_k = 1, and D any
// delay. A path that moves by at most v in every cycle that the chain sees passes within
//     Σ |b_k| (|k - D| + 1) v  =  C v
// of its setpoints and of what lies between them; so at  v ≤ v_f = tolerance / √(Σ over axes C²)  it keeps
// the tolerance, whatever its shape. No plateau is slower than v_f. After 60 plans and two more for each
// corner, or where a corner at v_f still exceeds the tolerance, each plan halves the velocity of the whole
// path, down to v_f: from rest there are at most
//     60 + 2 n + ⌈log2(v / v_f)⌉ + 2
// plans of n corners and a largest velocity v. Trying one costs as much as its blocks and turns
// (searched_spans.hpp), and its cycles once where it seems to keep the tolerance. What a moving machine has
// passed can no longer be slowed down: after as many plans the one before, which kept the tolerance, is
// driven to its stop (look_ahead.hpp), and the path continues from rest.
#pragma once

#include "analysis/motion/feed_limits.hpp"
#include "analysis/motion/path_trial.hpp"
#include "analysis/motion/velocity_search.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace axisc::motion {

/// The beginning of a block or the end of the path, and how fast the path may be around it.
struct Corner {
  double place = 0;  ///< along the path, units
  bool turns =
      false;  ///< the path may leave the programmed one here: points of it are counted to this corner
  /// Which sides the search `around` it covers: an arc is bent everywhere, and so is every block where axes
  /// are unlike.
  bool covers_before = false, covers_after = false;
  VelocitySearch at;      ///< within the kernels' reach
  VelocitySearch around;  ///< all that is nearer to this corner than to others

  bool passed = false;  ///< the machine is beyond it
  double time = 0;      ///< when the path planned last passes it, cycles
  /// The latest trial.
  std::uint64_t tried_path = 0;
  bool proved = false;  ///< at the time at which the machine will pass it
  double phase = 0;     ///< of that time in its cycle

  /// Tried up to the neighbouring corners, not only within reach.
  [[nodiscard]] bool is_whole() const { return covers_before || covers_after; }
};

struct TriedPath {
  std::span<TimedPiece const> pieces;
  /// Points from here on can be tried: the beginning of a path that begins at rest, otherwise cycles_before()
  /// after it.
  double valid_from = 0;
};

class ToleranceMonitor {
 public:
  /// Monitors nothing.
  ToleranceMonitor() = default;
  /// `tolerance` in units; 0: no monitoring. Runtime and answers must outlive this. `working` is called every
  /// millisecond or so.
  ToleranceMonitor(GroupRuntime& probe, std::vector<ChainAnswer> const& answers, double tolerance,
                   std::function<void()> working = {});

  [[nodiscard]] bool active() const { return trial_ != nullptr; }
  /// All axes have the same chain: straight lines stay straight.
  [[nodiscard]] bool alike() const { return trial_->alike(); }
  /// Cycles on either side of a corner.
  [[nodiscard]] double plateau() const { return plateau_; }
  /// Cycles around a point of the path within which another plan changes the measurement there.
  [[nodiscard]] double cycles_before() const { return trial_->cycles_before(); }
  [[nodiscard]] double cycles_after() const { return trial_->cycles_after(); }

  /// Largest velocity on a circle of this radius up to which every velocity keeps the tolerance however long
  /// it lasts.
  [[nodiscard]] double velocity_on(double radius);

  /// The verdict on a plan.
  enum class Verdict : std::uint8_t {
    keeps,    ///< the tolerance everywhere
    changed,  ///< velocities of corners: plan once more
    fails,    ///< where it can no longer be mended, because the machine has passed it or cannot brake for it
    exceeds,  ///< although all of the path is as slow as keeps any tolerance: nothing but rounding
  };
  /// Tries a plan where it is new, and changes the velocities of corners; `round` counts the plans of this
  /// path from 0. Cost: that of simulating the surroundings of new or changed corners.
  [[nodiscard]] Verdict judge(TriedPath const& path, std::span<Corner> corners, int round);

 private:
  void sign(TriedPath const& path, std::span<Corner const> corners);
  enum class Trial : std::uint8_t {
    search,  ///< of what is new, at setpoints and corners
    proof,   ///< of everything, also between them
  };
  void measure(TriedPath const& path, std::span<Corner> corners, Trial trial);
  enum class Change : std::uint8_t {
    none,
    some,
    stuck,  ///< a corner exceeds the tolerance and cannot be passed more slowly
  };
  [[nodiscard]] Change adjust(std::span<Corner> corners, double limit, bool raises) const;
  [[nodiscard]] bool exceeds(VelocitySearch const& search, double limit) const;
  bool lower(Corner& corner, double limit) const;
  /// Half the velocity everywhere, of a path that begins at rest. False where the floor has been reached.
  [[nodiscard]] bool slow_down(std::span<Corner> corners) const;
  /// The largest error of the corners that a plateau of this one covers.
  [[nodiscard]] double largest_around(std::span<Corner const> corners, std::size_t cell) const;

  std::unique_ptr<PathTrial> trial_;
  std::unique_ptr<CircleVelocities> circles_;
  double floor_ = 0;  ///< v_f
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
