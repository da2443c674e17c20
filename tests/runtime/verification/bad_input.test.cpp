#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace bad_input_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<ExactFilter> chain() {
  using namespace exact;
  return {bandstop_of_order_3(20, T, 3), with_share(delay(9), 0.3), with_share(highpass(30, T, 1), 0.6)};
}

bool all_finite(axisrt_axis_state const& state) {
  bool finite = std::isfinite(state.unfiltered) && std::isfinite(state.filtered);
  for (double const output : state.filter_output) finite = finite && std::isfinite(output);
  return finite;
}

}  // namespace

TEST_CASE("a bad setpoint is replaced by the last good setpoint") {
  for (double const bad :
       {not_a_number, -not_a_number, infinity, -infinity, 1e308, -1e308, std::nextafter(0x1p53, infinity)}) {
    TestRuntime disturbed(one_axis_image(chain()));
    TestRuntime held(one_axis_image(chain()));
    axisrt_reset(disturbed.runtime, 0, 100);
    axisrt_reset(held.runtime, 0, 100);
    for (int i = 0; i < 50; ++i) {
      double const good = 100 + 10.0 * i;
      REQUIRE(disturbed.step(good) == held.step(good));
      REQUIRE(disturbed.status == AXISRT_OK);
      REQUIRE(disturbed.step(bad) == held.step(good));
      REQUIRE(disturbed.status == AXISRT_BAD_INPUT);
      REQUIRE(disturbed.state().unfiltered == good);
    }
  }
}

TEST_CASE("2^53 is still a position") {
  TestRuntime runtime(one_axis_image({exact::pt1(30, T)}));
  axisrt_reset(runtime.runtime, 0, 0x1p53);
  CHECK(runtime.step(0x1p53) == 0x1p53);
  static_cast<void>(runtime.step(-0x1p53));
  CHECK(runtime.status == AXISRT_IMPLAUSIBLE);  // good, but no axis moves like this
}

TEST_CASE("each axis has its own status, and the worst is returned") {
  ImageRecord image = complete_image();
  image.axes.push_back(image.axes.front());
  TestRuntime runtime(write_image(image));
  REQUIRE(runtime.status == AXISRT_OK);
  axisrt_reset(runtime.runtime, 0, 0);
  axisrt_reset(runtime.runtime, 1, 0);
  double const in[] = {0, not_a_number, 5};
  double out[3] = {};
  std::uint8_t status[3] = {};
  CHECK(axisrt_step(runtime.runtime, in, out, status) == AXISRT_NOT_RESET);
  CHECK(status[0] == AXISRT_OK);
  CHECK(status[1] == AXISRT_BAD_INPUT);
  CHECK(status[2] == AXISRT_NOT_RESET);
  CHECK(out[1] == 0);
}

TEST_CASE("before a reset the output repeats the input, and zero instead of a bad one") {
  TestRuntime runtime(one_axis_image(chain()));
  for (double const in : {5.0, -1e9, 0x1p53, 0.0}) {
    CHECK(runtime.step(in) == in);
    CHECK(runtime.status == AXISRT_NOT_RESET);
  }
  for (double const in : {not_a_number, infinity, -infinity, 1e308, -0x1.0000000000001p53}) {
    CHECK(runtime.step(in) == 0);
    CHECK(runtime.status == AXISRT_NOT_RESET);
  }
  axisrt_axis_state const state = runtime.state();
  CHECK(state.reset_done == 0);
  CHECK(state.settled == 0);
  // nothing of it is remembered
  axisrt_reset(runtime.runtime, 0, 7);
  TestRuntime fresh(one_axis_image(chain()));
  axisrt_reset(fresh.runtime, 0, 7);
  CHECK(runtime.step(8) == fresh.step(8));
}

TEST_CASE("a million hostile inputs leave finite states") {
  TestRuntime runtime(one_axis_image(chain()));
  TestRuntime blocking(
      one_axis_image({exact::highpass(400, T, 10), exact::bandpass(1, T, 10), exact::delay(100)}));
  axisrt_reset(runtime.runtime, 0, 0);
  axisrt_reset(blocking.runtime, 0, 0);
  std::vector<double> const hostile = {not_a_number, infinity, -infinity, 1e308,   -1e308, 0x1p53,
                                       -0x1p53,      0.0,      5e-324,    -5e-324, 1e-300};
  std::mt19937_64 random(20'261'121);
  for (int i = 0; i < 1'000'000; ++i) {
    std::uint64_t const bits = random();
    double in = 0;
    switch (bits % 4) {
      case 0: in = hostile[(bits >> 2U) % hostile.size()]; break;
      case 1: in = i % 2 == 0 ? 0x1p53 : -0x1p53; break;
      case 2: in = std::ldexp(static_cast<double>(random()), -20); break;
      default: in = i % 2 == 0 ? 1e308 : -1e308;
    }
    bool const finite = std::isfinite(runtime.step(in)) && std::isfinite(blocking.step(in));
    if (!finite || (i % 1000 == 0 && !(all_finite(runtime.state()) && all_finite(blocking.state())))) {
      FAIL("not finite in cycle " << i);
    }
  }
  // and it recovers
  for (int i = 0; i < 20000; ++i) static_cast<void>(runtime.step(1e6));
  CHECK(runtime.step(1e6) == Approx(0.4e6).epsilon(1e-12));
}

TEST_CASE("the wildest sections that verification accepts stay finite") {
  AxisRecord axis;
  FilterRecord filter;
  filter.sections.assign(6, {.p = 64, .q = -64, .k = 0x1p-1000, .b = 2 - 0x1p-52});
  axis.filters.assign(3, filter);
  for (std::uint32_t i = 0; i < 3; ++i) axis.filters[i].index = i;
  axis.filters[1].blocks_constant = 1;
  set_share(axis.filters[2], 0.5);
  ImageRecord image;
  image.axes = {axis};
  TestRuntime runtime(write_image(image));
  REQUIRE(runtime.status == AXISRT_OK);
  axisrt_reset(runtime.runtime, 0, 1);
  for (int i = 0; i < 20000; ++i) {
    REQUIRE(std::isfinite(runtime.step(i % 2 == 0 ? 0x1p53 : -0x1p53)));
    REQUIRE(all_finite(runtime.state()));
  }
}

}  // namespace bad_input_test
