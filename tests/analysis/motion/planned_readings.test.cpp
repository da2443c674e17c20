// What words and readings do to a plan: figures by hand for 2000 mm/s² and ramps of 50 ms, cycles of 1 ms.
#include "planned_path.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <tuple>

namespace axisc::motion::planned_readings_test {
namespace {

using machine::Slope;

machine::AxisDynamics axis_of(double acceleration, double ramp_us) {
  machine::AxisDynamics axis;
  for (auto* const motion : {&axis.feed, &axis.rapid}) {
    motion->velocity = 500'000;
    for (auto* const stages : {&motion->step_up, &motion->step_down}) {
      stages->first = stages->second = acceleration;
    }
    for (auto* const ramp : {&motion->up, &motion->down}) {
      *ramp = {.acceleration = acceleration, .build_up = ramp_us, .take_back = ramp_us};
    }
  }
  axis.highest_acceleration = 2 * acceleration;
  return axis;
}

/// A channel of two such axes, and a path through end points in mm.
struct Plan {
  PathDynamics dynamics;
  BlockDynamics words;
  double feed_mm_min = 6000;
  test::PlannedPath path;

  explicit Plan(Slope slope) {
    dynamics.axes.assign(2, axis_of(2000, 50'000));
    words.slope = slope;
  }

  std::deque<ProgrammedBlock> blocks;
  ProgrammedBlock& to(double x, double y = 0) {
    auto& block = blocks.emplace_back();
    block.end = {x * units_per_mm, y * units_per_mm};
    block.feed = feed_mm_min / 60 * units_per_mm * dynamics.cycle_time.seconds();
    return block;
  }
  /// A circle about a point to the right of the beginning, back to it.
  ProgrammedBlock& circle(double radius) {
    auto& block = to(0);
    auto arc = std::make_shared<Arc>();
    arc->radius = radius * units_per_mm;
    arc->center_first = arc->radius;
    arc->phase = std::numbers::pi;
    arc->sweep = 2 * std::numbers::pi;
    arc->length = arc->radius * arc->sweep;
    block.arc = arc;
    return block;
  }
  void run() {
    auto const said = std::make_shared<BlockDynamics const>(words);
    LookAhead planner(PathLimits(dynamics), false, path);
    planner.begin({}, {}, 1);
    for (auto& block : blocks) {
      if (!block.dynamics) block.dynamics = said;
      planner.add(block);
    }
    planner.stop();
  }

  [[nodiscard]] double seconds() const {
    double cycles = 0;
    for (auto const& block : path.blocks) cycles += block.cycles();
    return cycles * dynamics.cycle_time.seconds();
  }
  /// mm/s
  [[nodiscard]] double out(std::size_t block) const { return path.blocks.at(block).motion.velocity_out / 10; }
  [[nodiscard]] double peak(std::size_t block) const {
    return path.blocks.at(block).motion.velocity_peak / 10;
  }
  [[nodiscard]] LimitedBy cause(std::size_t block) const { return path.blocks.at(block).motion.limited_by; }
};

/// 90° from X to Y, X with a weight, Y with another one.
double corner(machine::CornerReading reading, double x_weight, double y_weight) {
  Plan plan(Slope::trapez);
  plan.dynamics.readings.corner = reading;
  plan.dynamics.axes[0].acceleration_transition_weight = x_weight;
  plan.dynamics.axes[1].acceleration_transition_weight = y_weight;
  plan.to(50);
  plan.to(50, 50);
  plan.run();
  return plan.out(0);
}

}  // namespace

TEST_CASE("ten blocks of 2 mm") {
  for (auto const& [slope, hsc, expected] :
       {std::tuple{Slope::trapez, machine::HscReading::stretches, 0.371564023},
        std::tuple{Slope::hsc, machine::HscReading::stretches, 0.3},
        std::tuple{Slope::hsc, machine::HscReading::trapez, 0.371564023}}) {
    Plan plan(slope);
    plan.dynamics.readings.hsc = hsc;
    for (int i = 1; i <= 10; ++i) plan.to(2 * i);
    plan.run();
    CHECK(plan.seconds() == Approx(expected).epsilon(1e-8));
  }
  // The same for TRAPEZ where the acceleration need not be 0 at the ends of blocks.
  Plan plan(Slope::trapez);
  plan.dynamics.readings.borders = machine::BorderReading::continuous;
  for (int i = 1; i <= 10; ++i) plan.to(2 * i);
  plan.run();
  CHECK(plan.seconds() == Approx(0.3));
}

TEST_CASE("HSC goes on where its blocks are so short that it never comes to an end of acceleration") {
  // 1 mm in 5000 blocks at up to 500 mm/s: a window of 4096 of them is all ramps.
  Plan plan(Slope::hsc);
  plan.feed_mm_min = 30'000;
  for (int i = 1; i <= 5000; ++i) plan.to(0.0002 * i);
  plan.run();
  REQUIRE(plan.path.blocks.size() == 5000);
  for (std::size_t i = 0; i + 1 < 5000; ++i) CHECK(plan.out(i) > 0);
  CHECK(plan.out(4999) == Approx(0).margin(1e-6));
  // In one block 1 mm takes 4 q 50 ms with 100 q³ 0.1 = 1.
  double const whole = 0.2 * std::cbrt(0.1);
  CHECK(plan.seconds() > whole);
  CHECK(plan.seconds() < 2 * whole);
}

TEST_CASE("HSC gives a slow block in the middle acceleration 0 at its ends") {
  // 20 mm at 100 mm/s, 10 mm at 50 mm/s, 20 mm at 100: from rest to 100 in 100 ms, 100 to 50 with q = √½ in
  // 70.7 ms.
  Plan plan(Slope::hsc);
  plan.to(10);
  plan.to(20);
  plan.feed_mm_min = 3000;
  plan.to(30);
  plan.feed_mm_min = 6000;
  plan.to(40);
  plan.to(50);
  plan.run();
  double const braking = 0.1 * std::sqrt(0.5);
  double const along = (20 - 5 - 75 * braking) / 100;
  CHECK(plan.seconds() == Approx(2 * (0.1 + along + braking) + 0.2));
  CHECK(plan.out(1) == Approx(50));
  CHECK(plan.cause(2) == LimitedBy::feed);
}

TEST_CASE("a window that moves on leaves a velocity that is too fast for the next block's entry") {
  // Window of 2, TRAPEZ. Block 2 ends at rest as far as the control knows when block 1 begins: V = g(0) at
  // its beginning. Then block 3 appears, 0.1 mm: from it V_3 = g(0) of 0.1 mm. Way from the reached velocity
  // to V_3 is more than block 2 has (the hump): it ends with the highest velocity on the rising branch, which
  // is 0.
  Plan plan(Slope::trapez);
  plan.dynamics.channel.look_ahead_blocks = 2;
  plan.to(2);
  plan.to(4);
  plan.to(4.1);
  plan.run();
  // v = a t̄ q²/2 with 2 mm = v q t̄/2: q³ = 4 · 2 / (2000 · 0.1²).
  double const q = std::cbrt(8 / 20.0);
  CHECK(plan.out(0) == Approx(100 * q * q));
  CHECK(plan.out(1) == Approx(0).margin(1e-6));
  CHECK(plan.out(2) == 0);
  // With all of it known the second block is entered more slowly, and need not stop.
  Plan known(Slope::trapez);
  known.to(2);
  known.to(4);
  known.to(4.1);
  known.run();
  CHECK(known.out(0) < plan.out(0));
  CHECK(known.out(1) > 0.1);
  CHECK(known.seconds() < plan.seconds());
}

TEST_CASE("short blocks are limited by the window") {
  // v² = 2 a · 119 · 0.02 mm where block 120 of 120 may be the last.
  Plan plan(Slope::step);
  plan.feed_mm_min = 12'000;
  for (int i = 1; i <= 400; ++i) plan.to(0.02 * i);
  plan.run();
  CHECK(plan.out(200) == Approx(std::sqrt(2 * 2000 * 119 * 0.02)));
  CHECK(plan.cause(0) == LimitedBy::axis);
  CHECK(plan.cause(200) == LimitedBy::look_ahead);
  CHECK(plan.cause(390) == LimitedBy::braking);
  CHECK(plan.cause(399) == LimitedBy::stop);
  Plan wide(Slope::step);
  wide.feed_mm_min = 12'000;
  wide.dynamics.channel.look_ahead_blocks = 500;
  for (int i = 1; i <= 400; ++i) wide.to(0.02 * i);
  wide.run();
  CHECK(wide.out(199) == Approx(std::sqrt(2 * 2000 * 4.0)));
}

TEST_CASE("an exact stop ends a block at rest, a late brake begins behind it") {
  Plan plan(Slope::step);
  plan.to(20).exact_stop = true;
  plan.to(40).brakes_late = true;
  plan.feed_mm_min = 3000;
  plan.to(60);
  plan.run();
  CHECK(plan.out(0) == 0);
  CHECK(plan.path.blocks[0].stops);
  CHECK(plan.cause(0) == LimitedBy::feed);
  CHECK(plan.out(1) == Approx(100));
  CHECK(plan.peak(2) == Approx(100));
  // 20 mm: 1.25 mm in 25 ms from 100 to 50, 0.625 mm in 25 ms to rest; the rest at 50 mm/s.
  CHECK(plan.path.blocks[2].cycles() == Approx(25 + 25 + (20 - 1.875 - 0.625) / 50 * 1000));
  // G00 to G01 is not meant by it.
  Plan rapid(Slope::step);
  rapid.to(20).rapid = true;
  rapid.blocks.back().brakes_late = true;
  rapid.blocks.back().feed = std::numeric_limits<double>::infinity();
  rapid.to(40);
  rapid.run();
  CHECK(rapid.out(0) == Approx(100));
}

TEST_CASE("look-ahead functions, the least velocity of corners and limits of the path") {
  Plan plain(Slope::trapez);
  plain.to(50);
  plain.to(50, 50);
  plain.run();
  // a T²/tr = 0.04 mm/s
  CHECK(plain.out(0) == Approx(0.04));
  CHECK(plain.cause(0) == LimitedBy::feed);
  Plan least(Slope::trapez);
  least.words.least_corner_velocity = 3;
  least.to(50);
  least.to(50, 50);
  least.run();
  CHECK(least.out(0) == Approx(3));
  Plan without(Slope::trapez);
  without.words.limits_corners = false;
  without.to(50);
  without.to(50, 50);
  without.run();
  CHECK(without.out(0) == Approx(100));
  Plan limited(Slope::step);
  limited.words.vector = {.velocity = 50, .acceleration = 1000, .deceleration = 500};
  limited.to(50);
  limited.run();
  // Up 1.25 mm in 50 ms, down 2.5 mm in 100 ms.
  CHECK(limited.seconds() == Approx(0.15 + (50 - 3.75) / 50));
  // Velocity of the weights, and 0 %, which is 1 µm/s.
  Plan weighted(Slope::step);
  weighted.words.feed[0].velocity = 10;
  weighted.to(50);
  weighted.run();
  CHECK(weighted.peak(0) == Approx(50));
  CHECK(weighted.cause(0) == LimitedBy::axis);
}

TEST_CASE("weights beyond 100 percent end at the cap of the list") {
  // 2000 mm/s² up to a_max, which is 4000; P-AXIS-00292 where it is set.
  for (auto const& [cap, expected] : {std::pair{0.0, 4000.0}, std::pair{2500.0, 2500.0}}) {
    Plan plan(Slope::step);
    if (cap > 0) plan.dynamics.axes[0].weighted_acceleration = cap;
    plan.words.feed[0].up.acceleration = plan.words.feed[0].down.acceleration = 300;
    plan.to(50);
    plan.run();
    CHECK(plan.seconds() == Approx(0.5 + 100 / expected));
  }
  // Ramp times down to P-AXIS-00293.
  Plan plan(Slope::trapez);
  plan.dynamics.axes[0].shortest_weighted_ramp_time = 20'000;
  auto& up = plan.words.feed[0].up;
  auto& down = plan.words.feed[0].down;
  up.build_up = up.take_back = down.build_up = down.take_back = 10;
  plan.to(50);
  plan.run();
  CHECK(plan.seconds() == Approx(0.5 + 0.05 + 0.02));
}

TEST_CASE("a corner by its axes: all, those that speed up, those that slow down") {
  // w a T: 0.2 and 2 mm/s.
  CHECK(corner(machine::CornerReading::per_cycle, 100, 1000) == Approx(0.2));
  CHECK(corner(machine::CornerReading::up_only, 100, 1000) == Approx(2));
  CHECK(corner(machine::CornerReading::down_only, 100, 1000) == Approx(0.2));
  CHECK(corner(machine::CornerReading::up_only, 1000, 100) == Approx(0.2));
  CHECK(corner(machine::CornerReading::down_only, 1000, 100) == Approx(2));
}

TEST_CASE("the ramps of a slanted line: the weakest jerk, or the longest time") {
  // X: 2000 mm/s², 50 ms, 40 m/s³; Y: 4000 mm/s², 80 ms, 50 m/s³. Along 45° a = 2000 √2, jerk 40 √2 m/s³: 50
  // ms; the longest time is 80.
  for (auto const& [reading, ramp] : {std::pair{machine::ProjectionReading::weakest_jerk, 0.05},
                                      std::pair{machine::ProjectionReading::longest_ramp, 0.08}}) {
    Plan plan(Slope::trapez);
    plan.dynamics.axes[1] = axis_of(4000, 80'000);
    plan.dynamics.readings.projection = reading;
    plan.feed_mm_min = 30'000;
    plan.to(300, 300);
    plan.run();
    CHECK(plan.seconds() == Approx(300 * std::sqrt(2) / 500 + 500 / (2000 * std::sqrt(2)) + ramp));
  }
}

TEST_CASE("a circle shares its acceleration, or has all of it twice") {
  // 10 mm, 2000 mm/s²; ramps along it with √(a² - (v²/r)²), or a.
  for (auto const& [reading, part, along] :
       {std::tuple{machine::CircleReading::shared, std::numbers::sqrt2, std::sqrt(0.5)},
        std::tuple{machine::CircleReading::full, 1.0, 1.0}}) {
    Plan plan(Slope::step);
    plan.dynamics.readings.circle = reading;
    plan.feed_mm_min = 60'000;
    plan.circle(10);
    plan.run();
    double const v = std::sqrt(2000 * 10 / part);
    CHECK(plan.peak(0) == Approx(v));
    CHECK(plan.cause(0) == LimitedBy::curve);
    CHECK(plan.seconds() == Approx(20 * std::numbers::pi / v + v / (2000 * along)));
  }
}

TEST_CASE("sin² by its ramps, from end to end, or with the jerk of TRAPEZ") {
  // Δ = 300 mm/s, a t̄/2 = 100: Δ/a + 50 ms; 2 Δ/a; Δ/a + π/2 · 50 ms.
  for (auto const& [reading, ramp] :
       {std::pair{machine::SineReading::ramps, 0.2}, std::pair{machine::SineReading::whole_change, 0.3},
        std::pair{machine::SineReading::same_peak_jerk, 0.15 + std::numbers::pi / 2 * 0.05}}) {
    Plan plan(Slope::sin2);
    plan.dynamics.readings.sine = reading;
    plan.feed_mm_min = 18'000;
    plan.to(300);
    plan.run();
    CHECK(plan.seconds() == Approx(1 + ramp));
  }
}

TEST_CASE("ramps of whole cycles") {
  // 2 mm: q t = 36.84 cycles for each of four ramps become 37: v · 2 · 37 ms = 2 mm, so v = 27.03 mm/s.
  Plan plan(Slope::trapez);
  plan.dynamics.axes.assign(2, axis_of(1000, 50'000));
  plan.dynamics.readings.cycles = machine::CycleReading::whole;
  plan.to(2);
  plan.run();
  CHECK(plan.peak(0) == Approx(2 / 0.074));
  for (auto const& phase : plan.path.blocks[0].phases) {
    if (!phase.is_steady()) CHECK(phase.duration == Approx(std::round(phase.duration)));
  }
}

TEST_CASE("whole cycles of an acceleration that is just reached are not held") {
  // Δ = 50 mm/s = a t̄/2 with 500 mm/s² and ramps of 100 ms: 200 cycles up, 200 down, 1 mm along.
  for (double const away : {-1e-13, 0.0, 1e-13}) {
    Plan plan(Slope::trapez);
    plan.dynamics.axes.assign(2, axis_of(500, 100'000));
    plan.dynamics.readings.cycles = machine::CycleReading::whole;
    plan.feed_mm_min = 3000 * (1 + away);
    plan.to(11);
    plan.run();
    CHECK(plan.seconds() == Approx(0.42));
  }
}

TEST_CASE("weights of curves follow those of corners, or the other way round") {
  // Line to arc, P-CHAN-00009 = 1: v²/r ≤ w' a with w = 0.5, w' = 0.1; a line to a line at 90°: v ≤ w a T.
  auto const plan_of = [](machine::TransitionReading reading, double w, double w_curve) {
    Plan plan(Slope::trapez);
    plan.dynamics.readings.weights = reading;
    plan.dynamics.channel.limits_curvature_steps = true;
    for (auto& axis : plan.dynamics.axes) {
      axis.acceleration_transition_weight = w;
      axis.curvature_transition_weight = w_curve;
    }
    auto& line = plan.to(0);
    line.end[1] = 40 * units_per_mm;
    auto& arc = plan.circle(10);
    arc.end[1] = line.end[1];
    auto turned = std::make_shared<Arc>(*arc.arc);
    turned->center_second = line.end[1];
    turned->sweep = -turned->sweep;
    arc.arc = turned;
    plan.run();
    return plan.out(0);
  };
  CHECK(plan_of(machine::TransitionReading::r_follows_a, 500, 100) == Approx(100));
  CHECK(plan_of(machine::TransitionReading::r_follows_a, 50, 100) == Approx(std::sqrt(0.1 * 2000 * 10)));
  CHECK(plan_of(machine::TransitionReading::a_follows_r, 500, 100) == Approx(std::sqrt(0.1 * 2000 * 10)));
  CHECK(corner(machine::CornerReading::per_cycle, 100, 100) == Approx(0.2));
}

}  // namespace axisc::motion::planned_readings_test
