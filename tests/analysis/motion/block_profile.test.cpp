// The profile of one block: durations of an independent time-optimal generator, and figures by hand.
#include "analysis/motion/planning/block_profile.hpp"

#include "support/catch.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

namespace axisc::motion::block_profile_test {
namespace {

/// Ramps of one acceleration and the same time everywhere.
Ramp ramp_of(double acceleration, double time, RampRules const& rules = {}) {
  return {{.acceleration = acceleration, .at_slow_end = time, .at_fast_end = time}, rules};
}

std::vector<Phase> profile(BlockTask const& task) {
  std::vector<Phase> phases;
  append_profile(task, middle_velocity(task), phases);
  return phases;
}

double duration(std::vector<Phase> const& phases) {
  double sum = 0;
  for (auto const& phase : phases) sum += phase.duration;
  return sum;
}

double seconds(double length, double limit, Ramp const& ramp, double in = 0, double out = 0) {
  return duration(profile({.length = length,
                           .velocity_in = in,
                           .velocity_out = out,
                           .limit = limit,
                           .up = &ramp,
                           .down = &ramp}));
}

}  // namespace

TEST_CASE("blocks of one jerk take as long as time-optimal ones") {
  // v0, v1, L, v, a, j and the duration, computed by Ruckig.
  std::ifstream file(std::filesystem::path(AXISC_SOURCE_DIR) / "tests/analysis/motion/ruckig.csv");
  std::string line;
  std::getline(file, line);
  int rows = 0;
  for (; std::getline(file, line); ++rows) {
    std::istringstream fields(line);
    std::array<double, 7> row{};
    for (auto& value : row) {
      std::string field;
      std::getline(fields, field, ',');
      value = std::stod(field);
    }
    auto const [in, out, length, limit, acceleration, jerk, expected] = row;
    INFO(line);
    CHECK(seconds(length, limit, ramp_of(acceleration, acceleration / jerk), in, out) ==
          Approx(expected).epsilon(1e-9));
  }
  CHECK(rows == 1000);
}

TEST_CASE("100 mm at 100 mm/s") {
  std::array<AccelerationStep, most_axes + 1> const steps = {{{.above = 0, .acceleration = 1000}}};
  CHECK(seconds(100, 100, Ramp(steps, 1, false)) == Approx(1.1).epsilon(1e-12));
  CHECK(seconds(100, 100, ramp_of(1000, 0.05)) == Approx(1.15).epsilon(1e-12));
  // 300 ms, 2000 mm/s²: 100 mm/s are less than a t̄/2 = 600, so q = √(100/600), 2 q 0.3 s for each change.
  CHECK(seconds(100, 100, ramp_of(2000, 0.3)) == Approx(1 + 2 * std::sqrt(0.1 * 0.3 / 2)).epsilon(1e-12));
  CHECK(seconds(100, 100, ramp_of(1000, 0.05, {.sine = true})) == Approx(1.15).epsilon(1e-12));
}

TEST_CASE("2 mm are too short for the acceleration") {
  // Each ramp is v/2 · 2 q 0.05 long with v = 50 q²: 50 q³ 0.1 = 2, and all take 4 q 0.05 = 0.147361 s.
  double const q = std::cbrt(2 / (50 * 0.1));
  CHECK(seconds(2, 100, ramp_of(1000, 0.05)) == Approx(4 * q * 0.05).epsilon(1e-12));
  // Ramps that keep their time: v 0.1 = 2, 0.2 s.
  CHECK(seconds(2, 100, ramp_of(1000, 0.05, {.constant_times = true})) == Approx(0.2).epsilon(1e-12));
  // Times of whole units: 4 ramps of 1 each, v = 2/2, whatever the acceleration allows.
  CHECK(seconds(2, 100, ramp_of(1000, 0.05, {.whole_cycles = true})) == Approx(4));
}

TEST_CASE("sin² builds up the velocity of a ramp, and its largest jerk is π/2 p/T") {
  Ramp const ramp({.acceleration = 1000, .at_slow_end = 0.04, .at_fast_end = 0.08}, {.sine = true});
  std::vector<Phase> phases;
  ramp.append_up(10, 110, phases);
  REQUIRE(phases.size() == 3);
  // Δ/a = 0.1 s, of which h = 0.1 - 0.06 at the peak.
  CHECK(phases[1].duration == Approx(0.04));
  CHECK(duration(phases) == Approx(0.16));
  double largest = 0;
  double velocity = 10;
  double way = 0;
  for (auto const& phase : phases) {
    CHECK(phase.velocity == Approx(velocity));
    constexpr int parts = 2000;
    double const dt = phase.duration / parts;
    for (int i = 0; i < parts; ++i) {
      double const t = (i + 0.5) * dt;
      velocity += phase.acceleration_at(t) * dt;
      way += phase.velocity_at(t) * dt;
      largest = std::max(largest, std::abs(phase.jerk_at(t)));
    }
  }
  CHECK(velocity == Approx(110).epsilon(1e-6));
  CHECK(way == Approx(ramp.way(10, 110)).epsilon(1e-6));
  CHECK(largest == Approx(std::numbers::pi / 2 * 1000 / 0.04).epsilon(1e-5));
  // Other slopes of the acceleration, the same times of the velocity's change.
  Ramp const linear({.acceleration = 1000, .at_slow_end = 0.04, .at_fast_end = 0.08}, {});
  CHECK(linear.duration(10, 110) == Approx(ramp.duration(10, 110)));
  CHECK(ramp.way(10, 110) != Approx(linear.way(10, 110)));
}

TEST_CASE("one sin² from end to end takes twice the change by the acceleration") {
  auto const ramp = ramp_of(1000, 0.05, {.sine = true, .whole_change = true});
  CHECK(ramp.duration(0, 100) == Approx(0.2));
  CHECK(ramp.way(0, 100) == Approx(0.2 * 50));
  // Below a t̄/2 = 50 mm/s as with ramps.
  CHECK(ramp.duration(0, 32) == Approx(ramp_of(1000, 0.05, {.sine = true}).duration(0, 32)));
}

TEST_CASE("the way of braking has a hump") {
  auto const ramp = ramp_of(1000, 0.05);
  // Δ ≤ 50 mm/s has no constant acceleration: (v0 + v1) √((v0 - v1) 0.05/1000) is largest at v1 = v0/3.
  double const v0 = 30;
  double const hump = ramp.way(v0 / 3, v0);
  CHECK(hump > ramp.way(v0 / 3 - 0.1, v0));
  CHECK(hump > ramp.way(v0 / 3 + 0.1, v0));
  // On the rising branch.
  double const length = (hump + ramp.way(0, v0)) / 2;
  double const slow = ramp.slowest(v0 / 3, v0, length);
  CHECK(slow < v0 / 3);
  CHECK(ramp.way(slow, v0) == Approx(length).epsilon(1e-12));
}

TEST_CASE("the fast end of a ramp is what a way allows") {
  std::array<AccelerationStep, most_axes + 1> const steps = {{{.above = 0, .acceleration = 1000},
                                                              {.above = 40, .acceleration = 2000},
                                                              {.above = 90, .acceleration = 500}}};
  std::array<Ramp, 6> const ramps = {
      ramp_of(1000, 0.05),
      ramp_of(1000, 0.05, {.sine = true}),
      ramp_of(1000, 0.05, {.constant_times = true}),
      ramp_of(1000, 0.05, {.sine = true, .whole_change = true}),
      Ramp(steps, 3, false),
      Ramp({.acceleration = 700, .at_slow_end = 0.02, .at_fast_end = 0.11}, {.sine = true})};
  for (std::size_t i = 0; i < ramps.size(); ++i) {
    for (double const slow : {0.0, 3.0, 50.0, 200.0}) {
      for (double const fast : {slow + 1e-3, slow + 7, slow + 45, slow + 300}) {
        INFO(i << ": " << slow << " to " << fast);
        CHECK(ramps[i].fastest(slow, ramps[i].way(slow, fast)) == Approx(fast).epsilon(1e-11));
      }
    }
  }
}

TEST_CASE("a block that begins above its limit brakes at once") {
  // 100 mm/s, limit 50: STEP 2000 takes 25 ms and 1.875 mm; 18.125 mm more at 50 mm/s.
  std::array<AccelerationStep, most_axes + 1> const steps = {{{.above = 0, .acceleration = 2000}}};
  CHECK(seconds(20, 50, Ramp(steps, 1, false), 100, 50) == Approx(0.025 + 18.125 / 50));
  // With limited jerk and too short for two ramps: through a velocity below the limit.
  auto const ramp = ramp_of(1000, 0.05);
  double const length = ramp.way(10, 100) * 1.001;
  BlockTask const task{
      .length = length, .velocity_in = 100, .velocity_out = 10, .limit = 50, .up = &ramp, .down = &ramp};
  double way = 0;
  for (auto const& phase : profile(task)) way += phase.length;
  CHECK(way == Approx(length).epsilon(1e-12));
}

}  // namespace axisc::motion::block_profile_test
