// How fast a place of a path may be passed so that it keeps the tolerance: found by trial, because neighbours
// take part.
//
// A velocity that exceeds the tolerance is lowered by the power with which the last two trials' errors grew
// with it, one that stays too far below is raised, until `most_raises`; from then on it is only lowered, each
// time a little harder.
#pragma once

#include <limits>

namespace axisc::motion {

// Shares of the tolerance. Only the first decides whether the tolerance is kept. The others are a compromise
// between velocity and effort: what is proved at last is the path itself.

/// Points of the path are looked at more closely until the error halfway between two of them is within this
/// of the mean of both (path_trial.hpp). A parabola through the three exceeds the largest of them by at most
/// a quarter of this.
inline constexpr double straight_within = 0.002;
/// Errors above this are too large. What is not a parabola may exceed what was seen by half as much again as
/// the error halfway may deviate:  1 - 3/2 straight_within.
inline constexpr double largest_share = 1 - 1.5 * straight_within;
/// A velocity is found where it leaves errors in this band, and aims at its middle. It is as wide as needed
/// for some searches to meet in it, and stays below largest_share, because a path that other corners slow
/// down passes a place at another time in its cycle.
inline constexpr double largest_found = 0.989;
inline constexpr double smallest_found = 0.975;
inline constexpr double aimed_at = (smallest_found + largest_found) / 2;

/// How often a place is slowed down. The first lowerings take back what is known to keep the tolerance; those
/// after them come to their end.
inline constexpr int most_tries = 40;
inline constexpr int refining_rounds = 12;
inline constexpr int most_raises = 6;

struct VelocitySearch {
  double velocity = std::numeric_limits<double>::infinity();  ///< units per cycle; infinite: not limited
  double fastest = 0;                                         ///< most that the blocks allow

  double error = 0;           ///< of the last trial, units
  double tried_fastest = 0;   ///< of the path where the trial looked
  double tried_velocity = 0;  ///< the same, as far as this search limits it

  double kept = 0, exceeded = std::numeric_limits<double>::infinity();
  double error_before = 0, velocity_before = 0;
  int lowered = 0, raised = 0;

  [[nodiscard]] bool limits() const { return velocity != std::numeric_limits<double>::infinity(); }
  /// The result of a trial.
  void take(double found, double fastest_there);
  /// The error did not fall with the velocity: something else causes it.
  [[nodiscard]] bool is_vain() const;
  /// Below a velocity it need not go. `power` of the velocity with which the error grows, until two trials
  /// show it. False where it is already that low.
  bool lower(double tolerance, double floor, double power);
  /// The trial exceeded nothing, and this velocity slowed the path down more than it must. False where there
  /// is nothing more to gain.
  bool raise(double tolerance);

 private:
  [[nodiscard]] double growth(double now, double power) const;
};

}  // namespace axisc::motion
