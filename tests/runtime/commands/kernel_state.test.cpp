// What the axis state and the queries say about kernels, and the kernels' self-tests.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <string>
#include <vector>

namespace kernel_state_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;

}  // namespace

TEST_CASE("the kernel stands in the cascade where it acts") {
  std::vector<ExactFilter> const filters = {exact::pt1(40, T), exact::delay(4)};
  TestRuntime fir(kernel_image(moving_average(5), 2, filters));
  TestRuntime hsc(kernel_image(moving_average(5), 1, filters));
  TestRuntime without(one_axis_image(filters));
  TestRuntime alone(kernel_image(moving_average(5)));
  for (TestRuntime* runtime : {&fir, &hsc, &without, &alone}) runtime->reset_all(1000);
  CHECK(hsc.state().filter_output[2] == 1000);
  for (int i = 0; i < 100; ++i) {
    double const in = 1000.0 + 16 * i * i;
    double const out_fir = fir.step(in);
    double const out_hsc = hsc.step(in);
    static_cast<void>(without.step(in));
    REQUIRE(fir.state().filter_output[0] == without.state().filter_output[0]);
    REQUIRE(fir.state().filter_output[1] == without.state().filter_output[1]);
    REQUIRE(fir.state().filter_output[2] == out_fir);
    REQUIRE(hsc.state().filter_output[0] == alone.step(in));
    REQUIRE(hsc.state().filter_output[2] == out_hsc);
    REQUIRE(fir.state().filters == 3);
    REQUIRE(fir.state().filters_on == 7);
    REQUIRE(fir.state().kernel == 0);
    REQUIRE(fir.state().unfiltered == in);
    REQUIRE(fir.state().filtered == out_fir);
  }
}

TEST_CASE("a kernel that is off is seen in the axis state") {
  TestRuntime runtime(write_image(channel_image()));
  runtime.reset_all(0);
  CHECK(runtime.state(0).filters == 2);
  CHECK(runtime.state(0).filters_on == 3);
  CHECK(runtime.state(1).filters == 2);
  CHECK(runtime.state(1).filters_on == 2);  // HSC, the first, is off
  CHECK(runtime.state(2).filters == 0);
  REQUIRE(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
  CHECK(runtime.state(0).filters_on == 1);
  CHECK(runtime.state(0).kernel == AXISRT_NO_KERNEL);
  REQUIRE(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_HSC) == AXISRT_OK);
  CHECK(runtime.state(0).filters_on == 1);
  CHECK(runtime.state(1).filters_on == 3);
  CHECK(runtime.state(1).kernel == 2);
}

TEST_CASE("an axis is settled once the kernel has caught up") {
  TestRuntime runtime(kernel_image(delay_kernel(10)));
  runtime.reset_all(0);
  for (int i = 0; i < 10; ++i) {
    static_cast<void>(runtime.step(100));
    CHECK(runtime.state().settled == 0);
  }
  static_cast<void>(runtime.step(100));
  CHECK(runtime.state().settled == 1);
}

TEST_CASE("channels have names, unless they were stripped") {
  TestRuntime const runtime(write_image(channel_image()));
  std::size_t length = 0;
  CHECK(axisrt_group_count(runtime.runtime) == 1);
  char const* const name = axisrt_group_name(runtime.runtime, 0, &length);
  CHECK(std::string(name, length) == "channel");
  CHECK(std::string(axisrt_group_name(runtime.runtime, 1, &length)).empty());
  CHECK(length == 0);
  CHECK(std::string(axisrt_group_name(runtime.runtime, 1, nullptr)).empty());
  CHECK(axisrt_group_count(nullptr) == 0);

  ImageRecord image = channel_image();
  image.strip = true;
  TestRuntime const stripped(write_image(image));
  CHECK(axisrt_group_count(stripped.runtime) == 1);
  CHECK(std::string(axisrt_group_name(stripped.runtime, 0, &length)).empty());
  CHECK(length == 0);
}

TEST_CASE("self-tests of kernels leave no trace") {
  ImageRecord image = channel_image();
  TestRuntime tested(write_image(image));
  image.strip = true;
  TestRuntime untested(write_image(image));
  tested.reset_all(3);
  untested.reset_all(3);
  for (int i = 0; i < 30; ++i) REQUIRE(tested.step(3.0 + i) == untested.step(3.0 + i));
  CHECK(tested.state(0).kernel == untested.state(0).kernel);
  CHECK(tested.state(1).kernel == untested.state(1).kernel);
}

TEST_CASE("every kernel's self-test is run, also of those that only a bank chooses") {
  for (std::size_t kernel = 0; kernel < 4; ++kernel) {
    ImageRecord image = channel_image();
    image.kernels[kernel].samples.back().output += 0x1p-50;
    TestRuntime const wrong_sample(write_image(image));
    CHECK(wrong_sample.status == AXISRT_SELF_TEST_FAILED);
    image = channel_image();
    image.kernels[kernel].tails[0] += 0x1p-40;
    CHECK(TestRuntime(write_image(image)).status == AXISRT_SELF_TEST_FAILED);
    image = channel_image();
    image.kernels[kernel].samples.back().output += 0x1p-52;
    CHECK(TestRuntime(write_image(image)).status == AXISRT_OK);
  }
}

TEST_CASE("a slot may execute no kernel at all") {
  ImageRecord image;
  image.axes.emplace_back();
  image.slots = {{.kernel = none, .history = 0}};
  TestRuntime runtime(write_image(image));
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(4);
  for (int i = 0; i < 10; ++i) CHECK(runtime.step(4.25 * i) == 4.25 * i);
  CHECK(runtime.state().filters == 1);
  CHECK(runtime.state().filters_on == 0);
}

}  // namespace kernel_state_test
