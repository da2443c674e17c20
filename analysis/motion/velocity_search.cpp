#include "analysis/motion/velocity_search.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// A smaller power of the velocity shows that something else causes the error.
constexpr double least_growth = 0.3;
constexpr double most_growth = 3;
/// Two trials show the power only where their velocities are this far apart (a logarithm).
constexpr double least_apart = 1e-4;
/// A trial at this share of the one before should have a smaller error.
constexpr double clearly_slower = 0.95;
/// Each lowering is at least this one, so that a search ends.
constexpr double least_lowering = 0.998;
/// After the refining rounds each lowering goes below its target, by this much more than the one before, down
/// to half.
constexpr double added_lowering = 0.02;
constexpr double most_lowering = 0.5;
/// A search slows the path down where the path was as fast as it allowed, but for rounding.
constexpr double as_allowed = 0.999;
/// Between a velocity that keeps the tolerance and one that exceeds it nothing is left to try.
constexpr double nothing_between = 1.004;
/// A velocity that is raised is multiplied by at most this share of its power.
constexpr double most_raise = 4;

}  // namespace

void VelocitySearch::take(double found, double fastest_there) {
  error = found;
  tried_fastest = fastest_there;
  tried_velocity = std::min(velocity, fastest_there);
}

double VelocitySearch::growth(double now, double power) const {
  if (!(velocity_before > 0) || !(error_before > 0) || !(error > 0)) return power;
  double const apart = std::log(now / velocity_before);
  if (std::abs(apart) < least_apart) return power;
  double const found = std::log(error / error_before) / apart;
  return found > least_growth ? std::min(found, most_growth) : power;
}

bool VelocitySearch::is_vain() const {
  if (lowered == 0 || !(velocity_before > 0)) return false;
  double const slower = tried_velocity / velocity_before;
  return slower < clearly_slower && error > std::pow(slower, least_growth) * error_before;
}

bool VelocitySearch::lower(double tolerance, double floor, double power) {
  if (velocity <= floor) return false;
  ++lowered;
  double const from = tried_velocity > 0 ? std::min(tried_velocity, velocity) : std::min(fastest, velocity);
  double next = from * std::pow(aimed_at * tolerance / error, 1 / growth(from, power));
  exceeded = std::min(exceeded, from);
  if (kept >= from) kept = 0;
  if (lowered <= refining_rounds) {
    if (next <= kept) next = (kept + from) / 2;
  } else {
    next *= std::max(most_lowering, 1 - added_lowering * (lowered - refining_rounds));
  }
  velocity_before = from;
  error_before = error;
  velocity = std::max(floor, std::min(next, least_lowering * from));
  return true;
}

bool VelocitySearch::raise(double tolerance) {
  bool const slows_the_path = tried_velocity >= as_allowed * velocity;
  if (!limits() || raised >= most_raises || !slows_the_path) return false;
  if (error >= smallest_found * tolerance) return false;
  kept = std::max(kept, velocity);
  if (exceeded <= kept) exceeded = unlimited;
  if (exceeded < kept * nothing_between) return false;
  ++raised;
  double const share = std::clamp(aimed_at * tolerance / std::max(error, 1e-9), 1.0, most_raise);
  double next = velocity * std::pow(share, 1 / growth(velocity, 1));
  if (next >= exceeded) next = (kept + exceeded) / 2;
  velocity_before = velocity;
  error_before = error;
  velocity = next >= fastest ? unlimited : next;
  return true;
}

}  // namespace axisc::motion
