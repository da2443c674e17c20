#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>

namespace self_test_test {

using namespace axisc::test;

namespace {

/// The first filter's last sample, off by so many ulp of the largest input (which is 1).
Bytes image_with_error(double ulps) {
  ImageRecord image = complete_image();
  double& output = image.axes[0].filters[1].samples.back().output;
  output += std::ldexp(ulps, -52);
  return write_image(image);
}

}  // namespace

TEST_CASE("self-tests of a sound image pass, and leave no trace") {
  TestRuntime tested(write_image(complete_image()));
  ImageRecord stripped = complete_image();
  stripped.strip = true;
  TestRuntime untested(write_image(stripped));
  REQUIRE(tested.status == AXISRT_OK);
  REQUIRE(untested.status == AXISRT_OK);
  axisrt_reset(tested.runtime, 0, 3);
  axisrt_reset(untested.runtime, 0, 3);
  for (int i = 0; i < 30; ++i) REQUIRE(tested.step(3.0 + i) == untested.step(3.0 + i));
}

TEST_CASE("a self-test may be off by two ulp of its largest input, not by three") {
  CHECK(TestRuntime(image_with_error(1)).status == AXISRT_OK);
  TestRuntime const runtime(image_with_error(4));
  CHECK(runtime.status == AXISRT_SELF_TEST_FAILED);
  CHECK(runtime.runtime == nullptr);
}

TEST_CASE("a wrong coefficient is found by the self-test") {
  ImageRecord image = complete_image();
  double& q = image.axes[0].filters[0].sections[0].q;
  q *= 1 + 0x1p-30;
  CHECK(TestRuntime(write_image(image)).status == AXISRT_SELF_TEST_FAILED);
}

}  // namespace self_test_test
