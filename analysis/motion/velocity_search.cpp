#include "analysis/motion/velocity_search.hpp"

#include "analysis/motion/limited_by.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

/// The error e grows with a power p of the velocity: p = 1 at a corner, 2 on an arc, between them and beyond
/// where ramps and neighbours take part. Outside of these something else causes it.
constexpr double most_growth = 3;
constexpr double least_growth = 1 / most_growth;
/// Two trials show p only where their velocities are this far apart (a logarithm).
constexpr double least_apart = 1e-4;

// By  e2/e1 = (v2/v1)^p  the band of what is found is
//     b = largest_found / smallest_found
// in errors, and b^(1/p) in velocities.
double const band = largest_found / smallest_found;
/// An error that grows least leaves the band with this share of the velocity: after such a step it must be
/// smaller.
double const clearly_slower = std::pow(band, -1 / least_growth);
/// Between a velocity that keeps the tolerance and one that exceeds it by no more than this, no error that
/// grows most lies in the band: nothing is left to try.
double const nothing_between = std::pow(band, 1 / most_growth);
/// The step from the upper edge of the band to its middle where the error grows most. Each lowering is at
/// least this one, so that a search ends.
double const least_lowering = std::pow(aimed_at / largest_found, 1 / most_growth);

/// After the refining rounds each lowering goes below its target, each a little further than the one before:
/// the last halves it.
constexpr double most_lowering = 0.5;
constexpr double added_lowering = (1 - most_lowering) / (most_tries - refining_rounds);
/// A search slows the path down where the path was as fast as it allowed, but for rounding.
constexpr double as_allowed = 1 - 1e-6;
/// An error far below the band says little about p: it counts as no less than this share of the target.
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
    next *= 1 - added_lowering * (std::min(lowered, most_tries) - refining_rounds);
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
  double const counted = std::max(error, aimed_at * tolerance / most_raise);
  double const share = std::max(aimed_at * tolerance / counted, 1.0);
  double next = velocity * std::pow(share, 1 / growth(velocity, 1));
  if (next >= exceeded) next = (kept + exceeded) / 2;
  velocity_before = velocity;
  error_before = error;
  velocity = next;
  if (next >= fastest) velocity = unlimited;
  return true;
}

}  // namespace axisc::motion
