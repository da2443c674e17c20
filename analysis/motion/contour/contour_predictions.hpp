// What the filters of a channel do to simple contours at constant path velocity: a corner, a circle, a line,
// and the same corner passed in both directions.
//
// Contours lie in the plane of the first axis and another one, each of the others in turn; the first leg of a
// corner runs along the first axis. The figures are the largest of these planes. A channel of one axis is
// judged as if a second one were like it.
//
// Contour deviation is the greatest distance of a point of the contour from the filtered path, axis error the
// largest component, per axis, of the vector from such a point to the nearest point of the filtered path.
// Lengths are position units (0.1 µm), velocities units per NC cycle.
#pragma once

#include "analysis/motion/chain_answer.hpp"
#include "analysis/motion/point.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::motion {

struct NearestPoint;

struct ContourFigures {
  Point axis_error{};
  double deviation = 0;

  /// The largest of the axes' errors.
  [[nodiscard]] double largest_axis_error() const;
  /// Of one more point of the contour: the vector from it to the path.
  void take(NearestPoint const& nearest);
};

/// A sharp corner that lies on a cycle. `turn` is the change of direction in radians: 0 straight on, π back.
/// For identical symmetric kernels the axis error is  v R(0) |u1 - u0|  per component, the deviation  2 v
/// R(0) sin(turn/2).
[[nodiscard]] ContourFigures predict_corner(std::span<ChainAnswer const> answers, double velocity,
                                            double turn);

/// A full circle, long after its start: r (1 - A(v/r)) for identical kernels of magnitude A.
[[nodiscard]] ContourFigures predict_circle(std::span<ChainAnswer const> answers, double velocity,
                                            double radius);

/// The largest axis error of predict_circle(), which is not computed for planes that cannot have it.
[[nodiscard]] double largest_circle_error(std::span<ChainAnswer const> answers, double velocity,
                                          double radius);

/// A straight line halfway between two axes: 0 where their delays are equal.
[[nodiscard]] ContourFigures predict_line(std::span<ChainAnswer const> answers, double velocity);

/// Greatest distance between the filtered paths of a 90° corner that is passed in one direction and in the
/// other: 0 for symmetric kernels.
[[nodiscard]] double predict_parallel(std::span<ChainAnswer const> answers, double velocity);

/// The filtered path around a corner at the origin whose first leg comes along the first axis, one point per
/// cycle: the path that predict_corner() measures in one plane.
[[nodiscard]] std::vector<Point> corner_path(ChainAnswer const& first, ChainAnswer const& second,
                                             double velocity, double turn);

/// The filtered path of a full circle around the origin, in equal steps of the setpoint's angle from 0 on:
/// the path that predict_circle() measures in one plane.
[[nodiscard]] std::vector<Point> circle_path(ChainAnswer const& first, ChainAnswer const& second,
                                             double velocity, double radius, std::size_t points);

}  // namespace axisc::motion
