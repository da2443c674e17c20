#include "motion/interpolator.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

/// Cycles: rounding of the times of pieces.
constexpr double same_time = 1e-9;

/// Up (or down) to a velocity, along, down (or up) to the last one:
///     t1 = |v - v_in| / a,  t3 = |v - v_out| / a,  t2 = (L - s1 - s3) / v
struct Trapezoid {
  explicit Trapezoid(PathPiece const& piece)
      : a(piece.acceleration), v0(piece.velocity_in), length(piece.length) {
    double const v1 = piece.velocity_out;
    double const peak = std::sqrt((v0 * v0 + v1 * v1) / 2 + a * length);
    v = std::max({std::min(piece.velocity_limit, peak), std::min(v0, v1)});
    if (v < v1) v = v1;
    t1 = std::abs(v - v0) / a;
    t3 = std::abs(v - v1) / a;
    s1 = (v0 + v) / 2 * t1;
    double const s3 = (v + v1) / 2 * t3;
    double const s2 = std::max(0.0, length - s1 - s3);
    t2 = v > 0 ? s2 / v : 0;
  }

  [[nodiscard]] double duration() const { return t1 + t2 + t3; }
  [[nodiscard]] double velocity_at(double t) const {
    if (t < t1) return v0 + (v > v0 ? a : -a) * t;
    if (t <= t1 + t2) return v;
    return std::max(0.0, v - a * (t - t1 - t2));
  }
  [[nodiscard]] double way_at(double t) const {
    double s = 0;
    if (t < t1) {
      s = (v0 + velocity_at(t)) / 2 * t;
    } else if (t <= t1 + t2) {
      s = s1 + v * (t - t1);
    } else {
      s = s1 + v * t2 + (v + velocity_at(t)) / 2 * (t - t1 - t2);
    }
    return std::min(s, length);
  }

  double a, v0, length;
  double v = 0, t1 = 0, t2 = 0, t3 = 0, s1 = 0;
};

}  // namespace

void Interpolator::piece(PathBlock const& block, PathPiece const& piece) {
  Trapezoid const profile(piece);
  double const duration = profile.duration();
  for (; to_sample_ <= duration - same_time; to_sample_ += 1) {
    double const way = std::min(passed_ + profile.way_at(to_sample_), block.length);
    sink_.sample(plus(block.begin, way, block.direction), profile.velocity_at(to_sample_), block);
  }
  to_sample_ = std::max(0.0, to_sample_ - duration);
  passed_ += piece.length;
  velocity_ = piece.velocity_out;
  block_cycles_ += duration;
}

void Interpolator::block_end(PathBlock const& block, PathBlock const* next) {
  bool const on_cycle = to_sample_ <= 2 * same_time;
  sink_.corner(block, next, block_cycles_);
  passed_ = 0;
  block_cycles_ = 0;
  if (next != nullptr) {
    // A sample on the corner itself is exactly the corner.
    if (!on_cycle) return;
    sink_.sample(block.end, velocity_, *next);
    to_sample_ = 1;
    return;
  }
  sink_.sample(block.end, 0, block);
  to_sample_ = 1;
}

}  // namespace axisc::motion
