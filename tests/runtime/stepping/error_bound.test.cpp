// axisrt_axis_error_bound against ramps that the runtime executes, and against the formula for symmetric
// kernels.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace error_bound_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;

double bound_of(TestRuntime const& runtime, double velocity) {
  double bound = -1;
  CHECK(axisrt_axis_error_bound(runtime.runtime, 0, velocity, &bound) == AXISRT_OK);
  return bound;
}

/// The largest distance between the answer to a ramp of one unit per cycle and the ramp D cycles later.
double executed(TestRuntime& runtime, int cycles) {
  runtime.reset_all(0);
  std::vector<double> r;
  for (int n = 0; n < cycles; ++n) r.push_back(runtime.step(n));
  double const delay = cycles - 1 - r.back();
  double largest = 0;
  for (int n = 0; n < cycles; ++n) {
    largest = std::max(largest, std::abs(r[static_cast<std::size_t>(n)] - std::max(0.0, n - delay)));
  }
  return largest;
}

constexpr double unit_per_cycle = 100;  // um/s of 0.1 um in 1 ms

}  // namespace

TEST_CASE("a symmetric kernel cuts a corner by v sum of k b_k") {
  std::vector<double> const half = {5, 3, 1};
  TestRuntime const runtime(kernel_image(symmetric_kernel(half)));
  double const sum = 5 + 2 * (3 + 1);
  CHECK(bound_of(runtime, unit_per_cycle) == Approx((3 + 2 * 1) / sum).epsilon(1e-14));
  CHECK(bound_of(runtime, -30 * unit_per_cycle) == Approx(30 * (3 + 2 * 1) / sum).epsilon(1e-14));
  CHECK(bound_of(runtime, 0) == 0);
}

TEST_CASE("a moving average over 2h + 1 cycles cuts it by v h (h + 1) / (4 h + 2)") {
  for (std::uint32_t const h : {1U, 20U, 100U}) {
    TestRuntime const runtime(kernel_image(moving_average(h)));
    CHECK(bound_of(runtime, unit_per_cycle) == Approx(h * (h + 1.0) / (4.0 * h + 2)).epsilon(1e-12));
  }
}

TEST_CASE("a pure delay does not take an axis from its path") {
  CHECK(bound_of(TestRuntime(kernel_image(delay_kernel(7))), unit_per_cycle) == 0);
  CHECK(bound_of(TestRuntime(one_axis_image({exact::delay(3)})), unit_per_cycle) == 0);
  CHECK(bound_of(TestRuntime(one_axis_image({})), unit_per_cycle) == 0);
}

TEST_CASE("the bound of sections is what the runtime does") {
  for (auto const& filters : {std::vector{exact::pt1(10, T)}, std::vector{exact::lowpass(30, T, Quad{4})},
                              std::vector{exact::bandstop_of_order_3(20, T, 4), exact::pt1(40, T)},
                              std::vector{exact::with_share(exact::delay(3), 0.25)}}) {
    TestRuntime runtime(one_axis_image(filters));
    REQUIRE(runtime.status == AXISRT_OK);
    double const bound = bound_of(runtime, unit_per_cycle);
    double const measured = executed(runtime, 5000);
    CHECK(bound >= measured * (1 - 1e-6));
    // Between two cycles, where the delay lies, a sample may miss the peak by some parts in a thousand.
    CHECK(bound <= measured * 1.1 + 0.3);
  }
}

TEST_CASE("the bound of sections and a kernel together is what the runtime does") {
  TestRuntime runtime(kernel_image(moving_average(40), 2, {exact::lowpass(30, T, Quad{2})}));
  double const bound = bound_of(runtime, unit_per_cycle);
  double const measured = executed(runtime, 5000);
  CHECK(bound >= measured * (1 - 1e-6));
  CHECK(bound <= measured + 0.5);  // the peak lies between two cycles
}

TEST_CASE("what cannot be told is said") {
  double bound = 0;
  TestRuntime const blocking(one_axis_image({exact::bandpass(40, T, 2)}));
  CHECK(std::isinf(bound_of(blocking, unit_per_cycle)));
  TestRuntime runtime(write_image(channel_image()));
  CHECK(axisrt_axis_error_bound(runtime.runtime, 0, NAN, &bound) == AXISRT_BAD_INPUT);
  CHECK(axisrt_axis_error_bound(runtime.runtime, 9, 1, &bound) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_axis_error_bound(nullptr, 0, 1, &bound) == AXISRT_BAD_ARGUMENT);
  CHECK(axisrt_axis_error_bound(runtime.runtime, 0, 1, nullptr) == AXISRT_BAD_ARGUMENT);
  runtime.reset_all(0);
  for (int i = 0; i < 30; ++i) static_cast<void>(runtime.step_all({10.0 * i, 0, 0}));
  REQUIRE(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
  CHECK(axisrt_axis_error_bound(runtime.runtime, 0, 1, &bound) == AXISRT_BUSY);
}

}  // namespace error_bound_test
