#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>
#include <vector>

namespace step_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;

ImageRecord many_axes() {
  using namespace exact;
  ImageRecord image;
  std::vector<std::vector<ExactFilter>> const chains = {{lowpass(30, T, 1)},
                                                        {},
                                                        {delay(5), bandstop(20, T, 2)},
                                                        {with_share(highpass(9, T, 1), 0.5)},
                                                        {pt1(3, T), pt2(4, T), delay(100)}};
  for (std::vector<ExactFilter> const& chain : chains) {
    AxisRecord axis;
    axis.name = "A";
    for (ExactFilter const& filter : chain) {
      axis.filters.push_back(filter.record());
      axis.filters.back().index = static_cast<std::uint32_t>(axis.filters.size() - 1);
    }
    image.axes.push_back(axis);
  }
  return image;
}

void reset_all(TestRuntime& runtime) {
  for (std::uint32_t axis = 0; axis < axisrt_axis_count(runtime.runtime); ++axis)
    axisrt_reset(runtime.runtime, axis, 10.0 * axis);
}

}  // namespace

TEST_CASE("in may equal out") {
  TestRuntime apart(write_image(many_axes()));
  TestRuntime together(write_image(many_axes()));
  reset_all(apart);
  reset_all(together);
  for (int cycle = 0; cycle < 200; ++cycle) {
    std::vector<double> in;
    for (int axis = 0; axis < 5; ++axis) in.push_back(10.0 * axis + 1000 * std::sin(cycle / 10.0 + axis));
    std::vector<double> out(5);
    REQUIRE(axisrt_step(apart.runtime, in.data(), out.data(), nullptr) == AXISRT_OK);
    REQUIRE(axisrt_step(together.runtime, in.data(), in.data(), nullptr) == AXISRT_OK);
    REQUIRE(in == out);
  }
}

TEST_CASE("axes do not influence each other") {
  TestRuntime all(write_image(many_axes()));
  reset_all(all);
  std::vector<TestRuntime> alone;
  for (AxisRecord const& axis : many_axes().axes) {
    ImageRecord image;
    image.axes = {axis};
    alone.emplace_back(write_image(image));
    axisrt_reset(alone.back().runtime, 0, 10.0 * static_cast<double>(alone.size() - 1));
  }
  for (int cycle = 0; cycle < 200; ++cycle) {
    std::vector<double> in;
    for (int axis = 0; axis < 5; ++axis) in.push_back(10.0 * axis + 1000 * std::sin(cycle / 10.0 + axis));
    std::vector<double> out(5);
    axisrt_step(all.runtime, in.data(), out.data(), nullptr);
    for (std::size_t axis = 0; axis < 5; ++axis) REQUIRE(out[axis] == alone[axis].step(in[axis]));
  }
}

TEST_CASE("the additional interface runs the same filter with states of its own") {
  ImageRecord image;
  AxisRecord axis;
  axis.filters = {exact::pt1(30, T).record()};
  axis.interface_filters = axis.filters;
  image.axes = {axis};
  TestRuntime runtime(write_image(image));
  axisrt_reset(runtime.runtime, 0, 0);
  axisrt_reset_interface(runtime.runtime, 0, 0);
  std::vector<double> setpoint;
  for (int i = 0; i < 50; ++i) setpoint.push_back(runtime.step(100));
  for (int i = 0; i < 50; ++i) REQUIRE(runtime.step_interface(100) == setpoint[static_cast<std::size_t>(i)]);
  CHECK(runtime.state().filtered == setpoint.back());
}

TEST_CASE("a delay of zero cycles and a share of zero pass through") {
  ExactFilter const delay = exact::delay(0);
  ExactFilter const off = exact::with_share(exact::lowpass(20, T, 1), 0);
  FilterRecord nothing;
  nothing.realisation = 0;
  nothing.index = 2;
  AxisRecord axis;
  axis.filters = {delay.record(), off.record(), nothing};
  axis.filters[1].index = 1;
  ImageRecord image;
  image.axes = {axis};
  TestRuntime runtime(write_image(image));
  REQUIRE(runtime.status == AXISRT_OK);
  axisrt_reset(runtime.runtime, 0, 0);
  for (double const in : {1.0, 1e9 / 3, -7e-8}) CHECK(runtime.step(in) == in);
}

TEST_CASE("filters that share their coefficients have states of their own") {
  // Two axes point to one section.
  ImageRecord image;
  AxisRecord axis;
  axis.filters = {exact::pt1(30, T).record()};
  image.axes = {axis, axis};
  Bytes bytes = write_image(image);
  poke(bytes, section_offset(bytes, filters_kind) + 192 + 24, 0, 4);
  repair_checksums(bytes);
  TestRuntime runtime(bytes);
  REQUIRE(runtime.status == AXISRT_OK);
  axisrt_reset(runtime.runtime, 0, 0);
  axisrt_reset(runtime.runtime, 1, 500);
  double const in[] = {100, 500};
  double out[2] = {};
  for (int i = 0; i < 20; ++i) axisrt_step(runtime.runtime, in, out, nullptr);
  CHECK(out[0] > 0);
  CHECK(out[0] < 100);
  CHECK(out[1] == 500);
}

}  // namespace step_test
