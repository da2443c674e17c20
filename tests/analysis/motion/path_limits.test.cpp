// Limits along blocks and at junctions, by hand; 1 ms, position units of 0.1 µm: 1 mm/s is 10 units per
// cycle, 1000 mm/s² are 10 units per cycle².
#include "analysis/motion/path_block.hpp"
#include "analysis/motion/planning/junction.hpp"
#include "channels.hpp"
#include "support/catch.hpp"

#include <cmath>

namespace axisc::motion::path_limits_test {
namespace {

PathBlock line(PathDynamics const& dynamics, Point const& from, Point const& to, machine::Slope slope) {
  PathLimits limits(dynamics);
  ProgrammedBlock block;
  block.end = to;
  BlockDynamics words;
  words.slope = slope;
  block.dynamics = std::make_shared<BlockDynamics const>(words);
  return limits.block(block, from, length(minus(to, from)), 1e300, false);
}

PathDynamics two_axes(double first, double second) {
  PathDynamics dynamics;
  dynamics.axes = {test::step_axis(30'000, first), test::step_axis(10'000, second)};
  return dynamics;
}

double corner(PathDynamics const& dynamics, Point const& end, machine::Slope slope) {
  Point const middle{1e4};
  return corner_velocity(line(dynamics, {}, middle, slope), line(dynamics, middle, end, slope));
}

}  // namespace

TEST_CASE("no axis exceeds its velocity or acceleration along a path") {
  auto const dynamics = two_axes(800, 600);
  CHECK(line(dynamics, {}, {1e4, 0}, machine::Slope::step).velocity == Approx(300));
  CHECK(line(dynamics, {}, {0, -1e4}, machine::Slope::step).velocity == Approx(100));
  auto const slanted = line(dynamics, {}, {6e3, 8e3}, machine::Slope::step);
  CHECK(slanted.velocity == Approx(125));
  // From 0 to v with 600/0.8 = 750 mm/s²: v²/2a.
  CHECK(slanted.up.way(0, 75) == Approx(75.0 * 75 / (2 * 7.5)));
}

TEST_CASE("STEP takes the stage of each axis at its own velocity") {
  PathDynamics dynamics;
  dynamics.axes = {test::step_axis(500'000, 2000), test::step_axis(500'000, 1800)};
  // X: 500 mm/s² above 50 mm/s, which along 3-4-5 is a path velocity of 83.3 mm/s and 833 mm/s².
  dynamics.axes[0].feed.step_up = {.first = 2000, .second = 500, .changeover = 50'000};
  auto const block = line(dynamics, {}, {6e4, 8e4}, machine::Slope::step);
  // Below, Y's 1800/0.8 = 2250 mm/s².
  double const time = 833.3333333 / 22.5 + (1000 - 833.3333333) / 8.333333333;
  CHECK(block.up.duration(0, 1000) == Approx(time));
}

TEST_CASE("a corner is passed with the velocity step that the axes may make in one cycle") {
  // 90°: both axes change by v; 180°: one changes by 2 v. STEP knows no weights.
  auto dynamics = two_axes(800, 600);
  CHECK(corner(dynamics, {1e4, 1e4}, machine::Slope::step) == Approx(6));
  CHECK(corner(dynamics, {0, 0}, machine::Slope::step) == Approx(4));
  CHECK(std::isinf(corner(dynamics, {2e4, 0}, machine::Slope::step)));
  for (auto& axis : dynamics.axes) axis.acceleration_transition_weight = 500;
  CHECK(corner(dynamics, {1e4, 1e4}, machine::Slope::step) == Approx(6));
  // P-AXIS-00013 = 500: half of a T; 0: a T · T/tr with tr = 50 ms.
  CHECK(corner(dynamics, {1e4, 1e4}, machine::Slope::trapez) == Approx(3));
  for (auto& axis : dynamics.axes) axis.acceleration_transition_weight = 0;
  CHECK(corner(dynamics, {1e4, 1e4}, machine::Slope::trapez) == Approx(6.0 / 50));
}

TEST_CASE("a corner of 45 degrees has the velocities of the specification") {
  // 2000 mm/s², 50 ms: Y changes by v sin 45°. 2 mm/s · T/tr / sin 45° = 0.0565685 mm/s; weight 500: 1.41421.
  PathDynamics dynamics;
  dynamics.axes.assign(2, test::step_axis(500'000, 2000));
  CHECK(corner(dynamics, {2e4, 1e4}, machine::Slope::trapez) == Approx(0.565685425));
  for (auto& axis : dynamics.axes) axis.acceleration_transition_weight = 500;
  CHECK(corner(dynamics, {2e4, 1e4}, machine::Slope::trapez) == Approx(14.1421356));
}

}  // namespace axisc::motion::path_limits_test
