#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <vector>

namespace axis_state_test {

using namespace axisc::test;

namespace {
constexpr Quad T = Quad{1} / 1000;
}

TEST_CASE("the axis state shows every filter of the cascade") {
  using namespace exact;
  std::vector<ExactFilter> const filters = {lowpass(30, T, 1), delay(4), with_share(bandstop(20, T, 2), 0.5)};
  TestRuntime whole(one_axis_image(filters));
  TestRuntime first(one_axis_image({filters[0]}));
  TestRuntime two(one_axis_image({filters[0], filters[1]}));
  for (TestRuntime* runtime : {&whole, &first, &two}) axisrt_reset(runtime->runtime, 0, 1000);
  for (int i = 0; i < 100; ++i) {
    double const in = 1000.0 + i * i;
    double const out = whole.step(in);
    axisrt_axis_state const state = whole.state();
    REQUIRE(state.unfiltered == in);
    REQUIRE(state.filtered == out);
    REQUIRE(state.filter_output[0] == first.step(in));
    REQUIRE(state.filter_output[1] == two.step(in));
    REQUIRE(state.filter_output[2] == out);
    REQUIRE(state.filters == 3);
    REQUIRE(state.filters_on == 7);
    REQUIRE(state.reset_done == 1);
  }
}

TEST_CASE("an axis is settled while the output is within the position window") {
  TestRuntime runtime(one_axis_image({exact::pt1(10, T)}));
  CHECK(runtime.state().settled == 0);
  axisrt_reset(runtime.runtime, 0, 0);
  CHECK(runtime.state().settled == 1);
  double out = runtime.step(100);
  while (100 - out > 0.4) {
    REQUIRE(runtime.state().settled == 0);
    out = runtime.step(100);
  }
  CHECK(runtime.state().settled == 1);
}

TEST_CASE("an axis without filters passes its setpoint on") {
  TestRuntime runtime(one_axis_image({}));
  axisrt_reset(runtime.runtime, 0, 3);
  CHECK(runtime.step(4.5) == 4.5);
  axisrt_axis_state const state = runtime.state();
  CHECK(state.filters == 0);
  CHECK(state.filters_on == 0);
  CHECK(state.settled == 1);
}

}  // namespace axis_state_test
