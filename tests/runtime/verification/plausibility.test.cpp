// AXISRT_IMPLAUSIBLE: reported for the axis whose output moved too far, in its lane, in that cycle, and for
// no other.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cstdint>
#include <vector>

namespace plausibility_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;
/// 200 mm/s in units of 0.1 um per cycle.
constexpr double v = 2000;

/// Axes without filters, with a low-pass, and with two of them: several groups, lanes and widths.
ImageRecord image_of(std::uint32_t axes) {
  ImageRecord image;
  for (std::uint32_t i = 0; i < axes; ++i) {
    AxisRecord axis;
    axis.number = i + 1;
    for (std::uint32_t k = 0; k < i % 3; ++k) {
      axis.filters.push_back(exact::pt1(200, T).record());
      axis.filters.back().index = k;
    }
    image.axes.push_back(axis);
  }
  return image;
}

struct Cycle {
  axisrt_status worst;
  std::vector<double> out;
  std::vector<std::uint8_t> status;
};

Cycle step(TestRuntime const& runtime, std::vector<double> const& in) {
  Cycle cycle{.worst = AXISRT_OK, .out = in, .status = std::vector<std::uint8_t>(in.size(), 99)};
  cycle.worst = axisrt_step(runtime.runtime, in.data(), cycle.out.data(), cycle.status.data());
  return cycle;
}

}  // namespace

TEST_CASE("an output that jumps is implausible, in every lane") {
  for (std::uint32_t const axes : {1U, 3U, 13U, 40U}) {
    for (std::uint32_t jumping = 0; jumping < axes; ++jumping) {
      TestRuntime runtime(write_image(image_of(axes)));
      runtime.reset_all(1e6);
      std::vector<double> in(axes, 1e6);
      CHECK(step(runtime, in).worst == AXISRT_OK);
      in[jumping] += 100 * v;
      Cycle const cycle = step(runtime, in);
      REQUIRE(cycle.worst == AXISRT_IMPLAUSIBLE);
      for (std::uint32_t i = 0; i < axes; ++i) {
        REQUIRE(cycle.status[i] == (i == jumping ? AXISRT_IMPLAUSIBLE : AXISRT_OK));
      }
    }
  }
}

TEST_CASE("the limit is the peak gain and a quarter") {
  for (double const peak_gain : {1.0, 1.5}) {
    for (double const over : {-1e-6, 1e-6}) {
      ImageRecord image = image_of(1);
      image.axes[0].peak_gain = peak_gain;
      TestRuntime runtime(write_image(image));
      runtime.reset_all(0);
      CHECK(step(runtime, {(peak_gain + 0.25) * v + over}).worst ==
            (over > 0 ? AXISRT_IMPLAUSIBLE : AXISRT_OK));
    }
  }
}

TEST_CASE("kernels that amplify more than the one that works widen the limit") {
  ImageRecord image = image_of(1);
  image.kernels = {moving_average(2), delay_kernel(3, 0.5)};
  image.kernels[1].peak_gain = 3;
  image.slots = {{.axis = 0, .family = 2, .kernel = 0, .on_at_start = 0, .history = 8, .group = none}};
  TestRuntime runtime(write_image(image));
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(0);
  CHECK(step(runtime, {3.2 * v}).worst == AXISRT_OK);
  CHECK(step(runtime, {(3.2 + 3.3) * v}).worst == AXISRT_IMPLAUSIBLE);
}

TEST_CASE("what is no motion is not implausible") {
  TestRuntime runtime(write_image(image_of(5)));
  std::vector<double> in(5, 1e6);
  SECTION("an axis that was never reset") {
    CHECK(step(runtime, in).worst == AXISRT_NOT_RESET);
    in[2] = -1e6;
    CHECK(step(runtime, in).status[2] == AXISRT_NOT_RESET);
  }
  SECTION("a reset to another place") {
    runtime.reset_all(1e6);
    CHECK(step(runtime, in).worst == AXISRT_OK);
    runtime.reset_all(-5e6);
    CHECK(step(runtime, std::vector<double>(5, -5e6)).worst == AXISRT_OK);
  }
  SECTION("a new origin") {
    runtime.reset_all(1e6);
    CHECK(step(runtime, in).worst == AXISRT_OK);
    CHECK(axisrt_rebase(runtime.runtime, 3, -3.6e6) == AXISRT_OK);
    in[3] -= 3.6e6;
    CHECK(step(runtime, in).worst == AXISRT_OK);
  }
  SECTION("full speed") {
    runtime.reset_all(1e6);
    for (int cycle = 0; cycle < 100; ++cycle) {
      for (double& x : in) x += v;
      REQUIRE(step(runtime, in).worst == AXISRT_OK);
    }
  }
}

TEST_CASE("an axis without a velocity limit is not judged") {
  ImageRecord image = image_of(2);
  image.axes[0].velocity_limit = 0;
  TestRuntime runtime(write_image(image));
  runtime.reset_all(0);
  Cycle const cycle = step(runtime, {1e9, 1e9});
  CHECK(cycle.status[0] == AXISRT_OK);
  CHECK(cycle.status[1] == AXISRT_IMPLAUSIBLE);
}

}  // namespace plausibility_test
