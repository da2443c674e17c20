// Circles, dwells and slopes: figures by hand, in position units (0.1 µm) and cycles of 1 ms.
#include "analysis/motion/program/arc_words.hpp"
#include "channels.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace axisc::motion::circles_test {
namespace {

using std::numbers::pi;
using test::channel_of;
using test::Recorded;
using test::simulated;

constexpr bool constant_velocity = true;

/// Three axes with a moving average of this order.
Recorded run(std::uint32_t order, std::string const& program, bool keeps_velocity = false) {
  return simulated(channel_of({{.order = order}, {.order = order}, {.order = order}}), program,
                   keeps_velocity);
}

/// Setpoints of blocks with this label lie on this circle in the plane of two axes.
void check_on_circle(Recorded const& found, std::size_t first, std::size_t second, Point const& center,
                     double radius) {
  for (auto const& cycle : found.cycles) {
    auto const& nominal = cycle.point.point.nominal;
    double const distance = std::hypot(nominal[first] - center[first], nominal[second] - center[second]);
    CHECK(distance == Approx(radius).epsilon(1e-12));
  }
}

}  // namespace

TEST_CASE("a quarter, a full circle and a helix are as long as they are") {
  // F600 is 10 µm per cycle. π/2 · 10 mm; 2π · 5 mm; √((2π · 3 mm)² + (4 mm)²).
  auto const quarter = run(0, "G03 X10 Y10 I0 J10 F600\n", constant_velocity);
  CHECK(quarter.blocks.at(0).cycles == Approx(pi / 2 * 10 / 0.01));
  check_on_circle(quarter, 0, 1, {0, 1e5}, 1e5);
  auto const full = run(0, "G02 I5 F600\n", constant_velocity);
  CHECK(full.blocks.at(0).cycles == Approx(2 * pi * 5 / 0.01));
  check_on_circle(full, 0, 1, {5e4, 0}, 5e4);
  auto const helix = run(0, "G02 X0 Y0 Z4 I3 F600\n", constant_velocity);
  CHECK(helix.blocks.at(0).cycles == Approx(std::hypot(2 * pi * 3, 4) / 0.01));
  check_on_circle(helix, 0, 1, {3e4, 0}, 3e4);
  CHECK(helix.cycles.back().point.point.nominal[2] == Approx(4e4));
}

TEST_CASE("a circle by its radius: the shorter arc, or below 0 the longer one") {
  // From (0, 0) to (10, 0) about r = 10: the chord is the radius, so that the shorter arc is 60°, the longer
  // 300°.
  CHECK(run(0, "G02 X10 R10 F600\n", constant_velocity).blocks.at(0).cycles == Approx(pi / 3 * 10 / 0.01));
  CHECK(run(0, "G02 X10 R-10 F600\n", constant_velocity).blocks.at(0).cycles ==
        Approx(5 * pi / 3 * 10 / 0.01));
  // Clockwise over the top: the centre lies below the way, at -√75.
  auto const above = run(0, "G02 X10 R10 F600\n", constant_velocity);
  check_on_circle(above, 0, 1, {5e4, -std::sqrt(75) * 1e4}, 1e5);
  check_on_circle(run(0, "G03 X10 R10 F600\n", constant_velocity), 0, 1, {5e4, std::sqrt(75) * 1e4}, 1e5);
  check_on_circle(run(0, "G02 X10 R-10 F600\n", constant_velocity), 0, 1, {5e4, std::sqrt(75) * 1e4}, 1e5);
}

TEST_CASE("planes turn the first axis towards the second one") {
  // G18 is Z towards X: a quarter counterclockwise from (0, 0) about Z = -10 ends at X = 10, Z = -10.
  auto const zx = run(0, "G18 G03 Z-10 X10 K-10 F600\n", constant_velocity);
  CHECK(zx.blocks.at(0).cycles == Approx(pi / 2 * 10 / 0.01));
  check_on_circle(zx, 2, 0, {0, 0, -1e5}, 1e5);
  auto const yz = run(0, "G19 G03 Y-10 Z10 J-10 F600\n", constant_velocity);
  CHECK(yz.blocks.at(0).cycles == Approx(pi / 2 * 10 / 0.01));
}

TEST_CASE("what is no circle") {
  ArcWords words;
  words.to_center_first = 1e4;
  auto const mistake = [&](Point const& end) { return std::get<ArcMistake>(arc_of(words, {}, end)); };
  CHECK(mistake({1e4, 2e4}) == ArcMistake::misses_end);
  words.radius = 1e4;
  CHECK(mistake({2e4, 0}) == ArcMistake::both);
  words.to_center_first.reset();
  CHECK(mistake({}) == ArcMistake::full_by_radius);
  CHECK(mistake({3e4, 0}) == ArcMistake::too_small);
  words.radius.reset();
  CHECK(mistake({3e4, 0}) == ArcMistake::no_center);
  words.to_center_first = 0;
  CHECK(mistake({3e4, 0}) == ArcMistake::no_radius);
  // 3 µm beside the circle: the centre moves, both ends stay.
  words.to_center_first = 1e4;
  auto const rounded = std::get<Arc>(arc_of(words, {}, {2e4 + 30, 0}));
  CHECK(rounded.radius == Approx(1e4 + 15));
}

TEST_CASE("a circle is as fast as its axes can turn") {
  // a = 10 m/s², r = 1 mm: v² = a r / √2, so 84.09 mm/s or 840.9 units per cycle, whatever the feed.
  auto const found = run(0, "G02 I1 F60000\nI1\nI1\n");
  double fastest = 0;
  for (auto const& cycle : found.cycles) fastest = std::max(fastest, cycle.point.point.velocity);
  CHECK(fastest == Approx(1e4 * std::sqrt(0.01 / std::sqrt(2))).epsilon(1e-9));
  Point before{};
  Point change_before{};
  for (auto const& cycle : found.cycles) {
    Point const change = minus(cycle.point.point.nominal, before);
    CHECK(length(minus(change, change_before)) <= 100 * (1 + 1e-9));
    before = cycle.point.point.nominal;
    change_before = change;
  }
}

TEST_CASE("the deviation on a circle is r (1 - A), half of it where a line becomes the circle") {
  // v = 1000 units per cycle, r = 50000: θ = 0.02. A moving average of order 40 has
  //     A = sin(41 θ/2) / (41 sin(θ/2)) = 0.97216,  r (1 - A) = 1392.
  // At the tangent half of its taps lie on the line. The filtered point that belongs to it is
  //     x = Σ_{k=1..20} (r sin kθ - k v) / 41 = -71.4,  y = Σ r (1 - cos kθ) / 41 = 694.1
  // and the filtered path has turned by s = y' / x' there, with y' = Σ sin kθ, x' = 21 + Σ cos kθ: the
  // tangent is (y - s x) / √(1 + s²) = 697.8 away from it.
  auto const found = run(40, "G01 X30 F6000\nG03 X30 Y0 J5\n", constant_velocity);
  REQUIRE(found.blocks.size() == 2);
  double const gain = std::sin(0.41) / (41 * std::sin(0.01));
  CHECK(found.blocks[1].deviation == Approx(5e4 * (1 - gain)).epsilon(1e-9));
  double x = 0;
  double y = 0;
  double up = 0;
  double along = 21;
  for (int k = 1; k <= 20; ++k) {
    x += (5e4 * std::sin(0.02 * k) - 1000 * k) / 41;
    y += 5e4 * (1 - std::cos(0.02 * k)) / 41;
    up += std::sin(0.02 * k);
    along += std::cos(0.02 * k);
  }
  double const slope = up / along;
  CHECK(found.blocks[0].deviation == Approx((y - slope * x) / std::hypot(1, slope)).epsilon(1e-3));
}

TEST_CASE("a circle that begins across a line has the deviation of a corner") {
  // The line ends on a cycle. The taps of the filtered point that belongs to the corner: 20 on the line, at
  // -k v, and 20 on the circle, at (r (1 - cos kθ), r sin kθ).
  auto const found = run(40, "G01 X10 F6000\nG02 X20 Y0 I5\n", constant_velocity);
  double x = 0;
  double y = 0;
  for (int k = 1; k <= 20; ++k) {
    x += (-1000.0 * k + 5e4 * (1 - std::cos(0.02 * k))) / 41;
    y += 5e4 * std::sin(0.02 * k) / 41;
  }
  CHECK(found.blocks.at(0).deviation == Approx(std::hypot(x, y)).epsilon(0.02));
}

TEST_CASE("circles keep the tolerance, and come near to it") {
  for (double const radius : {0.5, 5.0, 50.0}) {
    auto const found = run(40, fmt::format("#FILTER ON [ORDER=40 AX_DEV=0.002]\nG01 X10 F20000\n"
                                           "G03 X10 Y0 J{0}\nG02 I{0}\nG01 X0\n",
                                           radius));
    REQUIRE(found.passes.size() == 1);
    double const largest =
        *std::max_element(found.passes[0].axis_error.begin(), found.passes[0].axis_error.end());
    CHECK(largest <= 20 * (1 + 1e-9));
    CHECK(largest > 19);
  }
}

TEST_CASE("G00 is as fast as the axes on its way allow") {
  // 500 mm/s, 10 m/s²: 100 mm take L/v + v/a = 250 cycles. Along two axes at once both limits are √2 as much,
  // along three √3, and so the same ways of each axis take the same time.
  CHECK(run(0, "G00 X100\n").blocks.at(0).cycles == Approx(250));
  CHECK(run(0, "G00 X100 Y-100\n").blocks.at(0).cycles == Approx(250));
  CHECK(run(0, "G00 X100 Y100 Z100\n").blocks.at(0).cycles == Approx(250));
  // 9 mm are too short for 500 mm/s: 2 √(L/a) = 60 cycles. F is that of the next G01: 9 mm at 30 mm/s, 300 +
  // 3 cycles.
  auto const both = run(0, "F1800 G00 X9\nG04 0\nG01 X0\n");
  CHECK(both.blocks.at(0).cycles == Approx(60).margin(1));
  CHECK(both.blocks.at(1).cycles == Approx(303).margin(1));
}

TEST_CASE("a dwell lasts as long as it says") {
  // 10 mm at 100 mm/s and 10 m/s²: L/v + v/a = 110 cycles, twice, and 500 between them.
  auto const found = run(0, "G01 X10 F6000\nG04 X0.5\nX20\n");
  CHECK(found.passes.at(0).cycles == Approx(720).margin(1));
  CHECK(run(0, "G01 X10 F6000\nG04 0.5\nX20\n").passes.at(0).cycles == found.passes[0].cycles);
  CHECK(run(0, "G01 X10 F6000\nG04 F0.5\nX20\n").passes.at(0).cycles == found.passes[0].cycles);
}

TEST_CASE("filters settle once where the path stops") {
  // 10 mm at 100 mm/s and 10 m/s²: 110 cycles; 41 taps have settled 40 cycles later. A dwell begins with its
  // stop, or when the one before is over.
  auto const cycles = [](std::string const& program) { return run(40, program).passes.at(0).cycles; };
  CHECK(cycles("G01 X10 F6000\n") == 110 + 40);
  CHECK(cycles("G01 X10 F6000\nG04 0\n") == 110 + 40);
  CHECK(cycles("G01 X10 F6000\nG04 0\nG04 0\n") == 110 + 40);
  CHECK(cycles("G01 X10 F6000\nG04 X0.01\n") == 110 + 40);
  CHECK(cycles("G01 X10 F6000\nG04 X0.5\n") == 110 + 500);
  CHECK(cycles("G01 X10 F6000\nG04 0\nG04 X0.5\n") == 110 + 40 + 500);
  CHECK(cycles("G01 X10 F6000\nG04 0\nG04 X0.01\n") == 110 + 40 + 10);
}

TEST_CASE("a stop leaves no deviation at a corner") {
  CHECK(run(40, "G01 X10 F6000\nY10\n").passes.at(0).deviation > 100);
  CHECK(run(40, "G01 X10 F6000\nG04 0\nY10\n").passes.at(0).deviation < 1e-6);
}

TEST_CASE("a ramp with sin² takes as long as one with constant jerk") {
  // 100 mm at 100 mm/s and 10 m/s²: L/v + v/a = 1010 cycles with STEP. Ramps of 50 ms: 100 mm/s are less than
  // a t̄/2 = 500 mm/s, so q = √(100/500), both ramps of a change take q 50 ms, and L/v + q 100 ms = 1044.72.
  CHECK(run(0, "G01 X100 F6000\n").blocks.at(0).cycles == Approx(1010));
  CHECK(run(0, "#SLOPE [TYPE=STEP]\nG01 X100 F6000\n").blocks.at(0).cycles == Approx(1010));
  double const ramp = 50 * std::sqrt(0.2);
  CHECK(run(0, "#SLOPE [TYPE=TRAPEZ]\nG01 X100 F6000\n").blocks.at(0).cycles == Approx(1000 + 2 * ramp));
  auto const smooth = run(0, "#SLOPE [TYPE=SIN2]\nG01 X100 F6000\n");
  CHECK(smooth.blocks.at(0).cycles == Approx(1000 + 2 * ramp));
  // p = q a = 44.72 units per cycle², and after t of the rise  v = p (t/2 - T/2π sin(πt/T)).
  double const peak = 100 * std::sqrt(0.2);
  double const t = 5;
  double const velocity = peak * (t / 2 - ramp / (2 * pi) * std::sin(pi * t / ramp));
  CHECK(smooth.cycles.at(4).point.point.velocity == Approx(velocity));
  double largest = 0;
  for (std::size_t i = 1; i < smooth.cycles.size(); ++i) {
    largest = std::max(
        largest, std::abs(smooth.cycles[i].point.point.velocity - smooth.cycles[i - 1].point.point.velocity));
  }
  CHECK(largest <= peak);
  CHECK(largest > 0.98 * peak);
}

}  // namespace axisc::motion::circles_test
