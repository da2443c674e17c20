#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>
#include <vector>

namespace rebase_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;
constexpr double offset = -3'600'000;  // one turn of a rotary axis

/// A rotating axis on a grid of 1/16 unit.
double rotation(int cycle) {
  return std::round((5e6 + 30'000.0 * cycle + 1e4 * std::sin(cycle / 7.0)) * 16) / 16;
}

/// Largest difference between a run that is rebased in cycle 200 and one that is not.
double largest_effect(std::vector<ExactFilter> const& filters, double dc_gain) {
  TestRuntime plain(one_axis_image(filters));
  TestRuntime rebased(one_axis_image(filters));
  axisrt_reset(plain.runtime, 0, rotation(0));
  axisrt_reset(rebased.runtime, 0, rotation(0));
  double effect = 0;
  for (int cycle = 0; cycle < 600; ++cycle) {
    if (cycle == 200) {
      double const before = rebased.state().filtered;
      REQUIRE(axisrt_rebase(rebased.runtime, 0, offset) == AXISRT_OK);
      REQUIRE(rebased.state().unfiltered == rotation(cycle - 1) + offset);
      effect = std::fabs(rebased.state().filtered - before - dc_gain * offset);
    }
    double const shift = cycle >= 200 ? offset : 0;
    double const expected = plain.step(rotation(cycle)) + dc_gain * shift;
    effect = std::max(effect, std::fabs(rebased.step(rotation(cycle) + shift) - expected));
  }
  return effect;
}

}  // namespace

TEST_CASE("rebase moves the origin and nothing else") {
  using namespace exact;
  // Positions have an ulp of 2^-29 to 2^-28 here; each of the compared outputs is rounded once.
  constexpr double two_roundings = 0x1p-28;
  CHECK(largest_effect({}, 1) == 0);
  CHECK(largest_effect({delay(20)}, 1) == 0);
  CHECK(largest_effect({bandstop_of_order_3(20, T, 3)}, 1) <= two_roundings);
  CHECK(largest_effect({lowpass(15, T, 1), delay(20), with_share(allpass(30, T, 1), 0.5)}, 1) <=
        two_roundings);
  CHECK(largest_effect({with_share(delay(50), 0.3), pt2(9, T)}, 1) <= two_roundings);
}

TEST_CASE("rebase of a chain that blocks the constant part shifts what it lets through") {
  using namespace exact;
  constexpr double two_roundings = 0x1p-28;
  CHECK(largest_effect({highpass(20, T, 1)}, 0) <= two_roundings);
  CHECK(largest_effect({with_share(highpass(20, T, 1), 0.25), delay(30)}, 0.75) <= two_roundings);
}

TEST_CASE("an axis is rebased a thousand times without drift") {
  TestRuntime runtime(one_axis_image({exact::pt1(50, T), exact::delay(10)}));
  axisrt_reset(runtime.runtime, 0, 0);
  double position = 0;
  for (int cycle = 0; cycle < 60'000; ++cycle) {
    position += 60'000;
    if (position > 3'600'000) {
      REQUIRE(axisrt_rebase(runtime.runtime, 0, offset) == AXISRT_OK);
      position += offset;
    }
    static_cast<void>(runtime.step(position));
  }
  for (int cycle = 0; cycle < 3000; ++cycle) static_cast<void>(runtime.step(position));
  CHECK(runtime.step(position) == position);
}

TEST_CASE("rebase refuses what cannot be shifted, and changes nothing then") {
  TestRuntime runtime(one_axis_image({exact::pt1(50, T)}));
  CHECK(axisrt_rebase(runtime.runtime, 0, 1) == AXISRT_NOT_RESET);
  REQUIRE(axisrt_reset(runtime.runtime, 0, 0x1p52) == AXISRT_OK);
  CHECK(axisrt_rebase(runtime.runtime, 0, NAN) == AXISRT_BAD_INPUT);
  CHECK(axisrt_rebase(runtime.runtime, 0, 0x1p54) == AXISRT_BAD_INPUT);
  CHECK(axisrt_rebase(runtime.runtime, 0, 0x1.8p52) == AXISRT_BAD_INPUT);
  CHECK(axisrt_rebase(runtime.runtime, 1, 1) == AXISRT_BAD_ARGUMENT);
  CHECK(runtime.step(0x1p52) == 0x1p52);
}

}  // namespace rebase_test
