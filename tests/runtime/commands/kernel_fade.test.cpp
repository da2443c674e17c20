// The change from one kernel to another: the quintic blend of what both compute, and its bounds.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/exact_kernel.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace kernel_fade_test {

using namespace axisc::test;

namespace {

constexpr int fade_cycles = 40;

/// One axis with kernel A from start-up; the banks switch to A and to B in 40 cycles, off does as well.
Bytes two_kernels(KernelRecord const& a, KernelRecord const& b) {
  ImageRecord image;
  image.axes.emplace_back();
  image.kernels = {a, b};
  auto const history = static_cast<std::uint32_t>(std::max(a.tails.size(), b.tails.size()));
  image.slots = {{.kernel = 0, .history = history, .group = 0}};
  image.groups = {{.name = "c",
                   .members = {0},
                   .banks = {{.fade_cycles = fade_cycles, .choices = {0}},
                             {.keywords = 1, .order = 2, .fade_cycles = fade_cycles, .choices = {1}}},
                   .off_fade_cycles = fade_cycles}};
  return write_image(image);
}

Quad quintic(int n) {
  Quad const t = static_cast<Quad>(n) / fade_cycles;
  return t * t * t * (10 - 15 * t + 6 * t * t);
}

double motion(int cycle) {
  return 1e6 + 2000.0 * cycle + 3000 * std::sin(cycle / 9.0);
}

}  // namespace

TEST_CASE("a fade blends what both kernels compute, from the first cycle to the last") {
  KernelRecord const a = moving_average(12);
  KernelRecord const b = symmetric_kernel({9, 7, 4, 1});
  TestRuntime runtime(two_kernels(a, b));
  ExactKernel kernel_a(a.tails, motion(0));
  ExactKernel kernel_b(b.tails, motion(0));
  runtime.reset_all(motion(0));
  constexpr int begin = 100;
  for (int cycle = 0; cycle < 400; ++cycle) {
    if (cycle == begin) REQUIRE(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 2) == AXISRT_OK);
    Quad const w = cycle < begin                 ? Quad{0}
                   : cycle < begin + fade_cycles ? quintic(cycle - begin + 1)
                                                 : Quad{1};
    Quad const y_a = kernel_a.step(motion(cycle));
    Quad const y_b = kernel_b.step(motion(cycle));
    double const y = runtime.step(motion(cycle));
    REQUIRE(static_cast<double>(absolute(static_cast<Quad>(y) - (y_a + w * (y_b - y_a)))) < 1e-9);
    REQUIRE(runtime.state().fading == (cycle >= begin && cycle < begin + fade_cycles - 1 ? 1U : 0U));
  }
}

TEST_CASE("the filter that is off fades to the setpoint itself") {
  KernelRecord const a = moving_average(12);
  TestRuntime runtime(two_kernels(a, moving_average(1)));
  ExactKernel kernel_a(a.tails, motion(0));
  runtime.reset_all(motion(0));
  for (int cycle = 0; cycle < 100; ++cycle) {
    if (cycle == 30) REQUIRE(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
    Quad const w = cycle < 30 ? Quad{0} : cycle < 70 ? quintic(cycle - 29) : Quad{1};
    Quad const x = motion(cycle);
    Quad const y_a = kernel_a.step(x);
    double const y = runtime.step(motion(cycle));
    REQUIRE(static_cast<double>(absolute(static_cast<Quad>(y) - (y_a + w * (x - y_a)))) < 1e-9);
    if (cycle >= 70) REQUIRE(y == motion(cycle));
  }
}

TEST_CASE("a second fade begins where the first one ended") {
  KernelRecord const a = moving_average(12);
  KernelRecord const b = symmetric_kernel({9, 7, 4, 1});
  TestRuntime runtime(two_kernels(a, b));
  ExactKernel kernel_b(b.tails, motion(0));
  runtime.reset_all(motion(0));
  for (int cycle = 0; cycle < 200; ++cycle) {
    if (cycle == 30) REQUIRE(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 2) == AXISRT_OK);
    if (cycle == 90) REQUIRE(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
    Quad const x = motion(cycle);
    Quad const y_b = kernel_b.step(x);
    double const y = runtime.step(motion(cycle));
    if (cycle < 70) continue;
    Quad const w = cycle < 90 ? Quad{0} : cycle < 130 ? quintic(cycle - 89) : Quad{1};
    REQUIRE(static_cast<double>(absolute(static_cast<Quad>(y) - (y_b + w * (x - y_b)))) < 1e-9);
  }
}

TEST_CASE("an axis stands as soon as no kernel of its own remembers an increment, and not before") {
  constexpr int remembered = 6;
  for (int const cycles : {0, 1, remembered - 1, remembered, remembered + 1, 100}) {
    INFO(cycles);
    TestRuntime runtime(two_kernels(moving_average(2), moving_average(remembered / 2)));
    runtime.reset_all(0);
    CHECK(runtime.step(10) < 10);
    for (int cycle = 0; cycle < cycles; ++cycle) static_cast<void>(runtime.step(10));
    REQUIRE(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 2) == AXISRT_OK);
    CHECK(runtime.state().fading == (cycles < remembered ? 1U : 0U));
    if (cycles >= remembered) CHECK(runtime.step(10) == 10);
  }
}

TEST_CASE("increments of a thousand-millionth of a unit are rest") {
  TestRuntime runtime(two_kernels(moving_average(2), moving_average(3)));
  runtime.reset_all(0);
  double x = 0;
  for (int cycle = 0; cycle < 10; ++cycle) static_cast<void>(runtime.step(x += 0x1p-31));
  REQUIRE(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 2) == AXISRT_OK);
  CHECK(runtime.state().fading == 0);
  for (int cycle = 0; cycle < 10; ++cycle) static_cast<void>(runtime.step(x += 0x1p-30));
  REQUIRE(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
  CHECK(runtime.state().fading == 1);
}

TEST_CASE("a constant setpoint comes out unchanged through any sequence of switches") {
  TestRuntime runtime(two_kernels(moving_average(50), delay_kernel(33, 0.7)));
  runtime.reset_all(0);
  double x = 0;
  for (int cycle = 0; cycle < 50; ++cycle) static_cast<void>(runtime.step(x = motion(cycle)));
  for (int cycle = 0; cycle < 100; ++cycle) static_cast<void>(runtime.step(x));
  for (int cycle = 0; cycle < 3000; ++cycle) {
    REQUIRE(runtime.step(x) == x);
    std::uint32_t const turn = static_cast<std::uint32_t>(cycle) * 2654435761U >> 30U;
    axisrt_status const status = turn == 0   ? runtime.command(AXISRT_ACTION_OFF)
                                 : turn == 1 ? runtime.command(AXISRT_ACTION_ON)
                                             : runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 2);
    REQUIRE(status == AXISRT_OK);
    REQUIRE(runtime.state().fading == 0);
  }
}

TEST_CASE("when the axis stops during a fade, the output arrives and the fade still takes its time") {
  TestRuntime runtime(two_kernels(moving_average(3), moving_average(2)));
  runtime.reset_all(0);
  double x = 0;
  for (int cycle = 0; cycle < 20; ++cycle) static_cast<void>(runtime.step(x = motion(cycle)));
  REQUIRE(runtime.command(AXISRT_ACTION_ON, AXISRT_KEYWORD_ORDER, 2) == AXISRT_OK);
  for (int cycle = 0; cycle < fade_cycles; ++cycle) {
    double const y = runtime.step(x);
    if (cycle >= 6) REQUIRE(y == x);
    if (cycle < fade_cycles - 1) REQUIRE(runtime.command(AXISRT_ACTION_OFF) == AXISRT_BUSY);
  }
  CHECK(runtime.command(AXISRT_ACTION_OFF) == AXISRT_OK);
}

}  // namespace kernel_fade_test
