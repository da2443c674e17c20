// One change of velocity along a path, between a slow and a fast end: how long it takes, how far it leads,
// and what it looks like.
//
// STEP has an acceleration a(v) that is constant between changeovers. So
//     t = Σ Δ_k / a_k,  s = Σ (v_k+1² - v_k²) / 2 a_k.
//
// The other slopes build the acceleration up and take it back. With Δ the change, a the most acceleration,
// t_s and t_f the times of its ramps at the slow and the fast end, t̄ = t_s + t_f:
//     Δ ≥ a t̄/2:  peak p = a for h = Δ/a - t̄/2
//     smaller Δ:   constant jerk: times q t_s and q t_f, p = q a, q = √(2Δ / a t̄)
//                  constant ramp times: p = 2Δ/t̄
//     s = v_slow t + p (c1 t_s² + t_s h/2 + h²/2 + (t_s/2 + h) t_f + c2 t_f²),
// with c1 = 1/6, c2 = 1/3, or for sin² c1 = 1/4 - 1/π², c2 = 1/4 + 1/π². Braking is this backwards in time,
// because c1 + c2 = 1/2.
#pragma once

#include "analysis/motion/planning/phase.hpp"
#include "analysis/motion/point.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace axisc::motion {

/// STEP: an acceleration that counts above a velocity.
struct AccelerationStep {
  double above = 0;         ///< units per cycle
  double acceleration = 0;  ///< units per cycle²
};

/// The other slopes.
struct RampTimes {
  double acceleration = 0;  ///< units per cycle²
  double at_slow_end = 0;   ///< cycles: up the build-up, down the take-back
  double at_fast_end = 0;
};

struct RampRules {
  bool sine = false;            ///< sin²
  bool constant_times = false;  ///< P-CHAN-00349
  /// Readings: one sin² from end to end; times of whole cycles, rounded up.
  bool whole_change = false, whole_cycles = false;
};

class Ramp {
 public:
  /// The velocity changes at once.
  Ramp() = default;
  Ramp(RampTimes const& times, RampRules const& rules);
  /// From velocity 0 on; accelerations may rise or fall.
  Ramp(std::array<AccelerationStep, most_axes + 1> const& steps, std::size_t count, bool whole_cycles);

  /// Cycles, and position units, from `slow` to `fast` or back.
  [[nodiscard]] double duration(double slow, double fast) const;
  [[nodiscard]] double way(double slow, double fast) const;
  struct Reach {
    double way = 0;
    double growth = 0;  ///< how fast the way grows with the fast end
  };
  [[nodiscard]] Reach reach(double slow, double fast) const;
  /// The highest fast end within a way. Cost: closed forms, or some steps of Newton's method.
  [[nodiscard]] double fastest(double slow, double length) const;
  /// The same for a slow end that has only grown since the last call: `share`, at first 1, is the q that was
  /// found.
  [[nodiscard]] double fastest(double slow, double length, double& share) const;
  /// The highest slow end below `slow` from which, or to which, the way to `fast` is short enough: with
  /// limited jerk the way grows with the slow end up to a hump. Negative where even 0 is too far.
  [[nodiscard]] double slowest(double slow, double fast, double length) const;

  void append_up(double from, double to, std::vector<Phase>& phases) const;
  void append_down(double from, double to, std::vector<Phase>& phases) const;

  [[nodiscard]] bool is_step() const { return count_ > 0; }
  [[nodiscard]] RampTimes const& times() const { return times_; }
  [[nodiscard]] RampRules const& rules() const { return rules_; }

 private:
  [[nodiscard]] double growth(double slow, double fast) const;
  /// What the acceleration does: p, then the times.
  struct Course {
    double peak = 0, slow_end = 0, held = 0, fast_end = 0;

    [[nodiscard]] double time() const { return slow_end + held + fast_end; }
  };
  [[nodiscard]] Course course(double change) const;
  [[nodiscard]] double way_of(Course const& course, double slow) const;
  [[nodiscard]] double fastest_continuous(double slow, double length) const;
  /// Calls take(from, to, acceleration) for each step between two velocities.
  template <class Take>
  void for_each_step(double slow, double fast, Take take) const;

  RampTimes times_;
  RampRules rules_;
  double c1_ = 0, c2_ = 0;
  double cubic_ = 0;        ///< way of the change alone, without h, at p = a
  double change_time_ = 0;  ///< t̄
  double half_change_ = 0;  ///< a t̄/2
  bool closed_ = false;     ///< `fastest` follows from q alone where p < a
  std::array<AccelerationStep, most_axes + 1> steps_{};
  std::size_t count_ = 0;
};

}  // namespace axisc::motion
