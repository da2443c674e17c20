// At rest a chain with DC gain 1 ends at its setpoint, exactly and for good.
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rest_test {

using namespace axisc::test;

namespace {

constexpr std::uint32_t cycle_time_ns = 125'000;
constexpr Quad T = Quad{1} / 8000;

/// Moves from 995e6 to 1e9 in a second; returns the number of cycles behind it after which y == x, 0 if
/// never.
int settle(TestRuntime& runtime, int longest) {
  axisrt_reset(runtime.runtime, 0, 995e6);
  for (int i = 1; i <= 8000; ++i) static_cast<void>(runtime.step(995e6 + i * 625.0));
  int last_difference = 0;
  for (int i = 1; i <= longest; ++i) {
    if (runtime.step(1e9) != 1e9) last_difference = i;
  }
  return last_difference == longest ? 0 : last_difference + 1;
}

}  // namespace

TEST_CASE("a settled chain gives back its setpoint exactly") {
  using namespace exact;
  std::vector<std::vector<ExactFilter>> const chains = {
      {bandstop_of_order_3(50, T, 10)},
      {lowpass(50, T, 1), pt2(30, T), with_share(allpass(80, T, 1), 0.37)},
      {with_share(delay(100), 0.9), pt1(20, T), thiran(2, Quad{24} / 10)},
      {delay(7)},
  };
  for (std::vector<ExactFilter> const& chain : chains) {
    TestRuntime runtime(one_axis_image(chain, cycle_time_ns), cycle_time_ns);
    CHECK(settle(runtime, 60000) > 0);
    CHECK(runtime.state().settled == 1);
  }
}

TEST_CASE("three band-stops of 1 Hz settle exactly and do not wander", "[.][slow]") {
  std::vector<ExactFilter> const filters(3, exact::bandstop_of_order_3(1, T, 10));
  TestRuntime runtime(one_axis_image(filters, cycle_time_ns), cycle_time_ns);
  CHECK(settle(runtime, 4'000'000) > 0);
}

TEST_CASE("states decay to zero instead of ending among the subnormal numbers") {
  using namespace exact;
  // With zero as the place of rest the output itself shows the states.
  for (ExactFilter const& filter :
       {bandpass(100, T, 1), bandpass(3900, T, 1), highpass(10, T, 1), lowpass(20, T, 1), lowpass(3900, T, 4),
        allpass(2000, T, 1), bandstop(3000, T, 10)}) {
    TestRuntime runtime(one_axis_image({filter}, cycle_time_ns), cycle_time_ns);
    axisrt_reset(runtime.runtime, 0, 0);
    static_cast<void>(runtime.step(1e-3));
    double smallest = 1;
    double last = 1;
    for (int i = 0; i < 200'000 && last != 0; ++i) {
      last = runtime.step(0);
      if (last != 0) smallest = std::min(smallest, std::fabs(last));
    }
    CHECK(last == 0);
    CHECK(smallest > 0x1p-600);
    for (int i = 0; i < 1000; ++i) REQUIRE(runtime.step(0) == 0);
  }
}

}  // namespace rest_test
