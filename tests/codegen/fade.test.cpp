#include "codegen/fade.hpp"

#include "machines.hpp"
#include "naive_kernels.hpp"
#include "support/catch.hpp"

#include <cmath>

namespace axisc::codegen::fade_test {

TEST_CASE("a fade takes the fewest cycles that fulfil both inequalities", "[fade]") {
  test::Random random(8);
  int standstill = 0;
  for (int i = 0; i < 20'000; ++i) {
    double const distance = std::ldexp(random.between(1, 2), static_cast<int>(random.below(12)) - 3);
    MotionLimits const limits{
        .velocity = std::ldexp(random.between(1, 2), static_cast<int>(random.below(14))),
        .acceleration = std::ldexp(random.between(1, 2), static_cast<int>(random.below(14)) - 3)};
    std::uint32_t const cycles = fade_cycles(distance, limits);
    CAPTURE(distance, limits.velocity, limits.acceleration);
    REQUIRE(cycles == test::naive_fade(distance, limits.velocity, limits.acceleration));
    standstill += cycles == 0 ? 1 : 0;
  }
  CHECK(standstill > 100);
  CHECK(standstill < 10'000);
}

TEST_CASE("a fade takes at least a cycle and at most 4096", "[fade]") {
  MotionLimits const limits{.velocity = 100, .acceleration = 10};
  CHECK(fade_cycles(0, limits) == 1);
  CHECK(fade_cycles(1e-9, limits) == 1);
  CHECK(fade_cycles(1e9, limits) == 0);
  // The limit of velocity does not bind before that of acceleration does: F is close to 15 L where v/a is
  // small.
  MotionLimits const stiff{.velocity = 1e-6, .acceleration = 1e6};
  CHECK(fade_cycles(273, stiff) == 4096);
  CHECK(fade_cycles(273.1, stiff) == 0);
}

TEST_CASE("an axis without limits is never faded in motion", "[fade]") {
  CHECK(fade_cycles(1, {.velocity = 0, .acceleration = 1}) == 0);
  CHECK(fade_cycles(1, {.velocity = 1, .acceleration = 0}) == 0);
  CHECK(fade_cycles(1, {.velocity = -1, .acceleration = -1}) == 0);
  CHECK(fade_cycles(1, {.velocity = NAN, .acceleration = 1}) == 0);
}

TEST_CASE("limits become units and cycles", "[fade]") {
  // 500 mm/s are 5e6 units of 0.1 um a second; 8 m/s^2 are 8e7 units.
  MotionLimits const limits = motion_limits(500'000, 8000, {2'000'000});
  CHECK(limits.velocity == Approx(10'000).epsilon(1e-14));
  CHECK(limits.acceleration == Approx(320).epsilon(1e-14));
}

TEST_CASE("the distance of two kernels is that of their tails", "[fade]") {
  design::KernelDesign a;
  design::KernelDesign b;
  a.tail_sums = {0.75, 0.5, 0.25};
  b.tail_sums = {1.0, -0.5};
  CHECK(tail_distance(&a, &b) == 0.25 + 1.0 + 0.25);
  CHECK(tail_distance(&b, &a) == tail_distance(&a, &b));
  CHECK(tail_distance(&a, nullptr) == 1.5);
  CHECK(tail_distance(nullptr, &b) == 1.5);
  CHECK(tail_distance(&a, &a) == 0);
  CHECK(tail_distance(nullptr, nullptr) == 0);
}

}  // namespace axisc::codegen::fade_test
