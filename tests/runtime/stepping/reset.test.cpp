#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace reset_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;

std::vector<double> const positions = {0, 1e9, -1e9, 1e9 + 1.0 / 3, 0x1p53, -0x1p53, 1e-30};

std::vector<ExactFilter> dc_gain_1() {
  using namespace exact;
  return {bandstop_of_order_3(20, T, 3), with_share(delay(9), 0.3), with_share(lowpass(30, T, 1), 0.6)};
}

}  // namespace

TEST_CASE("after reset the first output of a chain with DC gain 1 is the position, exactly") {
  TestRuntime runtime(one_axis_image(dc_gain_1()));
  for (double const position : positions) {
    static_cast<void>(runtime.step(123));
    REQUIRE(axisrt_reset(runtime.runtime, 0, position) == AXISRT_OK);
    CHECK(runtime.state().filtered == position);
    for (int i = 0; i < 30; ++i) REQUIRE(runtime.step(position) == position);
  }
}

TEST_CASE("after reset a chain that blocks the constant part gives its steady output") {
  TestRuntime blocking(one_axis_image({exact::lowpass(50, T, 1), exact::highpass(20, T, 1)}));
  TestRuntime shared(one_axis_image(
      {exact::with_share(exact::bandpass(20, T, 1), 0.25), exact::delay(6), exact::pt1(9, T)}));
  for (double const position : positions) {
    REQUIRE(axisrt_reset(blocking.runtime, 0, position) == AXISRT_OK);
    REQUIRE(axisrt_reset(shared.runtime, 0, position) == AXISRT_OK);
    for (int i = 0; i < 30; ++i) {
      REQUIRE(blocking.step(position) == 0);
      REQUIRE(shared.step(position) == 0.75 * position);
    }
    CHECK(shared.state().filtered == 0.75 * position);
  }
}

TEST_CASE("what was before a reset leaves no trace") {
  TestRuntime used(one_axis_image(dc_gain_1()));
  TestRuntime fresh(one_axis_image(dc_gain_1()));
  axisrt_reset(used.runtime, 0, 5);
  for (int i = 0; i < 100; ++i) static_cast<void>(used.step(std::sin(i) * 1e6));
  axisrt_reset(used.runtime, 0, 777);
  axisrt_reset(fresh.runtime, 0, 777);
  for (int i = 0; i < 100; ++i) REQUIRE(used.step(777.0 + i) == fresh.step(777.0 + i));
}

TEST_CASE("a reset to what is no position changes nothing") {
  TestRuntime runtime(one_axis_image(dc_gain_1()));
  double const infinity = std::numeric_limits<double>::infinity();
  for (double const bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN(), 0x1.8p53}) {
    CHECK(axisrt_reset(runtime.runtime, 0, bad) == AXISRT_BAD_INPUT);
    CHECK(runtime.state().reset_done == 0);
  }
  REQUIRE(axisrt_reset(runtime.runtime, 0, 42) == AXISRT_OK);
  CHECK(axisrt_reset(runtime.runtime, 0, infinity) == AXISRT_BAD_INPUT);
  CHECK(runtime.step(42) == 42);
}

TEST_CASE("the additional interface is reset apart from the setpoint") {
  TestRuntime runtime(write_image(complete_image()));
  double const in[] = {1000, 2000};
  double out[2] = {};
  std::uint8_t status[2] = {};
  CHECK(axisrt_step_interface(runtime.runtime, in, out, status) == AXISRT_NOT_RESET);
  CHECK(status[0] == AXISRT_OK);  // no filter there, nothing to reset
  CHECK(status[1] == AXISRT_NOT_RESET);
  CHECK(out[0] == 1000);
  CHECK(out[1] == 2000);
  REQUIRE(axisrt_reset(runtime.runtime, 1, 5) == AXISRT_OK);
  CHECK(axisrt_step_interface(runtime.runtime, in, out, status) == AXISRT_NOT_RESET);
  REQUIRE(axisrt_reset_interface(runtime.runtime, 1, 2000) == AXISRT_OK);
  CHECK(axisrt_step_interface(runtime.runtime, in, out, status) == AXISRT_OK);
  CHECK(out[1] == 2000);
  CHECK(runtime.state(1).filtered == 5);
}

}  // namespace reset_test
