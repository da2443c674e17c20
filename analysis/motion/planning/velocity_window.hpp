// The look-ahead of the control: which velocity the path has from block to block.
//
// When block k begins, the control knows the blocks k … k+N-1, and can stop at their end. Backwards from
// there,
//     V_k = min(limit, highest v0 with s(v0, V_{k+1}) ≤ L_k),
// forwards the highest velocity up to V_{k+1} that the block can reach.
//
// With limited jerk the way s(v0, v1) of braking grows from v1 = 0 up to a hump, v0/3 without constant
// acceleration, and falls only then. So a block more in the window can lower V_k below the velocity that the
// path has already. Therefore what a shorter window allowed stays allowed: V_k never falls. Where V_{k+1} is
// then out of reach, the block ends with the highest velocity on the rising branch, which a shorter window
// was content with.
//
// Three things keep this cheap. V_k is at least what an earlier window allowed, so that nothing is computed
// as long as that is more than the path can reach; the way backwards ends where it changes nothing; and
// several windows are followed backwards at the same time. What windows in between would have allowed makes
// no difference: because of the hump, if s(v0, v1) ≤ L for any v1 up to V_{k+1}, it is for V_{k+1} or for 0,
// with which the block was the last of a window once.
#pragma once

#include "analysis/motion/limited_by.hpp"
#include "analysis/motion/planning/block_profile.hpp"
#include "analysis/motion/planning/ramp.hpp"

#include <cstddef>
#include <vector>

namespace axisc::motion {

/// A block, or a part of one. Position units and cycles.
struct PathElement {
  std::size_t block = 0;  ///< for the caller
  double length = 0;
  double velocity = 0;  ///< most within it
  LimitedBy velocity_cause = LimitedBy::feed;
  double entry = 0;  ///< most at its beginning
  LimitedBy entry_cause = LimitedBy::braking;
  Ramp const* up = nullptr;
  Ramp const* down = nullptr;
  bool ends_block = true;
  bool across = false;  ///< the acceleration need not be 0 at its ends (hsc_stretches.hpp)

  double allowed = 0;             ///< V_k, or what an earlier window allowed
  double share = 1;               ///< see Ramp::fastest
  bool waits_for_blocks = false;  ///< V_k is that low because the window ends
};

/// An element with its velocities.
struct PassedElement {
  PathElement element;
  double velocity_in = 0, velocity_middle = 0, velocity_out = 0;
  LimitedBy limited_by = LimitedBy::feed;  ///< before complete(): unless it reaches its own velocity
  bool waits_for_blocks = false;           ///< the last velocity is that low because the window ends
  bool is_possible = true;                 ///< it can be passed so
};

class VelocityWindow {
 public:
  /// `moves`: the path is not at its beginning, and each element was the last of a window before.
  void begin(double velocity, bool moves);
  void push(PathElement const& element);
  [[nodiscard]] std::size_t size() const { return elements_.size() - first_; }
  /// Passes the first of `known` elements; `ends`: the path stops after the last one. Where up to
  /// `further_windows` more are there already, the control learns of one of them with each pass.
  [[nodiscard]] PassedElement pass(std::size_t known, bool ends);

  static constexpr std::size_t further_windows = 3;

 private:
  void prime(std::size_t end);
  [[nodiscard]] bool raise_before(std::size_t next_at);
  void raise(std::size_t end);
  void forget_passed();

  std::vector<PathElement> elements_;
  std::size_t first_ = 0;    ///< of those that are not passed
  std::size_t pending_ = 0;  ///< the first that those before it do not know of
  double velocity_ = 0;
  bool moves_ = false;
  bool primed_ = false;
};

/// How an element ends that begins with a velocity and is to end with another one.
struct Exit {
  double velocity = 0;
  bool is_possible = true;
};
[[nodiscard]] Exit exit_of(PathElement const& element, double velocity_in, double wanted);
/// Why it does not end faster; `next` is what follows it.
[[nodiscard]] LimitedBy cause_of(double velocity_out, PathElement const* next, bool waits_for_blocks,
                                 bool ends);
/// An element between these velocities.
[[nodiscard]] BlockTask task_of(PassedElement const& passed);
/// Finds the velocity along its middle, and the cause of its velocities.
void complete(PassedElement& passed);
/// The cause alone, where the velocity along its middle is known.
void complete(PassedElement& passed, double middle);

}  // namespace axisc::motion
