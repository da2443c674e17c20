// How far the contour deviates where blocks of NC programs meet, behind a moving average of order 40.
#include "constructs.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace construct_deviations_test {

using namespace axisc::test;
using std::numbers::pi;
using std::numbers::sqrt2;

namespace {

constexpr double way = 10;  ///< µm per cycle
constexpr int half = 20;    ///< of the 41 taps lie on either side of the middle one

/// The filtered point that belongs to a corner is so far away along each leg, in µm: Σ k way / 41.
constexpr double leg = way * (half * (half + 1) / 2) / 41;

/// A circle of so many µm passes a symmetric filter with A = sin(41 θ/2) / (41 sin(θ/2)), θ = way / r: its
/// radius shrinks by r (1 - A). Of a helix only a share of the way lies in the plane.
double shrinks(double r, double share = 1) {
  double const theta = way * share / r;
  return r * (1 - std::sin(41 * theta / 2) / (41 * std::sin(theta / 2)));
}

/// Where a line along X becomes a circle along its tangent, one half of the taps lies on the circle. The
/// filtered point that belongs to this place is (x, y) away; the filtered path has turned there, by Σ sin kθ
/// to 21 + Σ cos kθ.
double tangent_deviation(double r) {
  double x = 0;
  double y = 0;
  double up = 0;
  double along = half + 1;
  for (int k = 1; k <= half; ++k) {
    double const angle = k * way / r;
    x += (r * std::sin(angle) - k * way) / 41;
    y += r * (1 - std::cos(angle)) / 41;
    up += std::sin(angle);
    along += std::cos(angle);
  }
  double const slope = up / along;
  return (y - slope * x) / std::hypot(1, slope);
}

/// Where a circle begins across a line along X: a corner whose second leg bends on along X.
double across_deviation(double r) {
  double x = 0;
  double y = 0;
  for (int k = 1; k <= half; ++k) {
    double const angle = k * way / r;
    x += (r * (1 - std::cos(angle)) - k * way) / 41;
    y += r * std::sin(angle) / 41;
  }
  return std::hypot(x, y);
}

}  // namespace

TEST_CASE("constructs: deviation where blocks meet") {
  // Legs that turn by φ differ by |u1 - u0| = 2 sin(φ/2), and so many legs away is the filtered point.
  double const right_angle = sqrt2 * leg;
  double const half_of_it = 2 * std::sin(pi / 8) * leg;
  double const tangent = tangent_deviation(1000);
  double const across = across_deviation(5000);
  double const helix = shrinks(1000, 2 * pi / std::hypot(2 * pi, 4));
  // One half of the taps bends the path half as much.
  CHECK(tangent == Approx(shrinks(1000) / 2).epsilon(0.002));
  auto const found = simulated_construct("transitions.nc");
  check_deviations(found, {0, 0, right_angle, right_angle, 0, half_of_it, half_of_it, 0, tangent,
                           shrinks(1000), 0, across, across, helix});
  CHECK(found["blocks"][2]["max_axis_error_um"].get<double>() == Approx(leg));
}

TEST_CASE("constructs: stops and dwells") {
  auto const found = simulated_construct("stops.nc");
  // A block that passes a corner has one ramp of v/a = 1 ms, along v²/2a = 5 µm: L/v + v/2a.
  auto const one_ramp = [](double L) { return L / 10 + 0.0005; };
  check_times(found, {{"N30", one_ramp(10.005)},
                      {"N40", one_ramp(10)},
                      {"N50", rest_to_rest(10)},
                      {"N60", rest_to_rest(10)},
                      {"N70", one_ramp(10.005)},
                      {"N80", one_ramp(10)},
                      {"N100", rest_to_rest(10)},
                      {"N120", rest_to_rest(10)}});
  double const corner = sqrt2 * leg;
  check_deviations(found, {corner, corner, 0, 0, corner, corner, 0, 0});
  // The motion up to each stop, in whole cycles; 40 cycles until 41 taps have settled, for N45, N55, N65 and
  // the last dwell; two dwells that are longer.
  double const moving = 2.002 + 1.001 + 1.001 + 2.002 + 1.001 + 1.001;
  CHECK(found["passes"][0]["time_s"].get<double>() == Approx(moving + 4 * 0.04 + 0.5 + 0.25));
}

}  // namespace construct_deviations_test
