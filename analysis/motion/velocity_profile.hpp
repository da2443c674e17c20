// How a stretch of a path is passed: up to a velocity, along, down to the last one.
//
//     t1 = |v - v_in| / a,  t3 = |v - v_out| / a,  t2 = (L - s1 - s3) / v
//
// a is the mean acceleration of a ramp. With sin² it is half of the largest one, and a share τ of the ramp's
// time t gives
//     v = v_in + Δv (τ - sin(2πτ) / 2π),  s = v_in τ t + Δv t (τ² / 2 + (cos(2πτ) - 1) / 4π²)
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::motion {

/// Cycles: rounding of the times of pieces.
inline constexpr double same_time = 1e-9;

/// A stretch of one block: from one velocity to another, in between as fast as limit and acceleration allow.
struct PathPiece {
  double length = 0;  ///< position units
  double velocity_in = 0, velocity_out = 0, velocity_limit = 0;
  double acceleration = 0;  ///< mean of a ramp
  bool smooth = false;      ///< sin² instead of constant
};

class VelocityProfile {
 public:
  VelocityProfile() = default;
  explicit VelocityProfile(PathPiece const& piece)
      : a_(piece.acceleration), v0_(piece.velocity_in), length_(piece.length), smooth_(piece.smooth) {
    double const v1 = piece.velocity_out;
    double const peak = std::sqrt((v0_ * v0_ + v1 * v1) / 2 + a_ * length_);
    v_ = std::max({std::min(piece.velocity_limit, peak), std::min(v0_, v1)});
    if (v_ < v1) v_ = v1;
    t1_ = std::abs(v_ - v0_) / a_;
    t3_ = std::abs(v_ - v1) / a_;
    s1_ = (v0_ + v_) / 2 * t1_;
    double const s3 = (v_ + v1) / 2 * t3_;
    double const s2 = std::max(0.0, length_ - s1_ - s3);
    // Infinite where the path is at rest.
    t2_ = s2 > 0 ? s2 / v_ : 0;
  }

  /// Cycles.
  [[nodiscard]] double duration() const { return t1_ + t2_ + t3_; }
  /// Between these times the velocity stays the same.
  [[nodiscard]] double steady_from() const { return t1_; }
  [[nodiscard]] double steady_to() const { return t1_ + t2_; }
  /// At this many cycles after its beginning.
  [[nodiscard]] double velocity_at(double t) const {
    if (t < t1_) return v0_ + (v_ > v0_ ? a_ : -a_) * t1_ * gained(t / t1_);
    if (t <= t1_ + t2_) return v_;
    return std::max(0.0, v_ - a_ * t3_ * gained((t - t1_ - t2_) / t3_));
  }
  [[nodiscard]] double way_at(double t) const {
    double s = 0;
    if (t < t1_) {
      s = v0_ * t + (v_ > v0_ ? a_ : -a_) * t1_ * t1_ * passed(t / t1_);
    } else if (t <= t1_ + t2_) {
      s = s1_ + v_ * (t - t1_);
    } else {
      double const braking = std::min(t - t1_ - t2_, t3_);
      s = s1_ + v_ * t2_ + v_ * braking - (t3_ > 0 ? a_ * t3_ * t3_ * passed(braking / t3_) : 0);
    }
    return std::min(s, length_);
  }

 private:
  /// Shares of a ramp's change of velocity, and its integral, after a share of its time.
  [[nodiscard]] double gained(double share) const {
    share = std::min(share, 1.0);
    return smooth_ ? share - std::sin(full_turn * share) / full_turn : share;
  }
  [[nodiscard]] double passed(double share) const {
    double const half = share * share / 2;
    return smooth_ ? half + (std::cos(full_turn * share) - 1) / (full_turn * full_turn) : half;
  }

  static constexpr double full_turn = 2 * std::numbers::pi;
  double a_ = 0, v0_ = 0, length_ = 0;
  double v_ = 0, t1_ = 0, t2_ = 0, t3_ = 0, s1_ = 0;
  bool smooth_ = false;
};

}  // namespace axisc::motion
