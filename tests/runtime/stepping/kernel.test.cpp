// Linear-phase kernels in the cycle: accuracy, rest, bad input, rebase, reset.
#include "axisrt.h"
#include "support/catch.hpp"
#include "tests/runtime/exact_kernel.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace kernel_test {

using namespace axisc::test;

namespace {

constexpr Quad T = Quad{1} / 1000;

struct Case {
  std::string name;
  KernelRecord kernel;
};

KernelRecord kernel_of_tails(std::vector<double> tails) {
  auto const count = static_cast<std::uint32_t>(tails.size());
  return {.type = 3, .half_width = 0, .delay_cycles = count, .tails = std::move(tails), .samples = {}};
}

std::vector<Case> cases() {
  std::vector<Case> list;
  for (std::uint32_t const h : {1U, 2U, 10U, 37U, 100U}) {
    list.push_back({"moving average, h = " + std::to_string(h), moving_average(h)});
  }
  std::vector<double> bell(31);
  std::vector<double> sinc(51);
  for (std::size_t k = 0; k < bell.size(); ++k) {
    bell[k] = std::exp(-static_cast<double>(k * k) / 200);
  }
  for (std::size_t k = 0; k < sinc.size(); ++k) {
    double const x = 0.3 * static_cast<double>(k);
    sinc[k] = k == 0 ? 1 : std::sin(x) / x;
  }
  list.push_back({"bell", symmetric_kernel(bell)});
  list.push_back({"negative taps", symmetric_kernel(sinc)});
  list.push_back({"delay of 1", delay_kernel(1)});
  list.push_back({"delay of 100", delay_kernel(100)});
  list.push_back({"blended delay", delay_kernel(17, 0.4)});
  std::mt19937 random(5);
  for (std::size_t length = 1; length <= 9; ++length) {
    std::vector<double> tails(length);
    for (double& tail : tails) tail = static_cast<double>(random()) * 0x1p-31 - 1;
    list.push_back({std::to_string(length) + " tails", kernel_of_tails(tails)});
  }
  return list;
}

/// A random walk in velocity near 1e9, with stops, reversals and rare jumps.
class RandomMotion {
 public:
  explicit RandomMotion(unsigned seed) : random_(seed) {}
  double next() {
    auto const event = static_cast<unsigned>(random_() % 200);
    if (event == 0) velocity_ = 0;
    if (event == 1) velocity_ = -velocity_;
    if (event == 2) position_ += 12345.678;
    if (event > 100) velocity_ += static_cast<double>(random_()) * 0x1p-26 - 32;
    position_ += velocity_;
    return position_;
  }

 private:
  std::mt19937 random_;
  double position_ = 1e9;
  double velocity_ = 0;
};

double ulp(double x) {
  double const magnitude = std::fabs(x);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

/// Largest error over its bound, ulp(max(|x|, |y|))/2 + 2^-42 D; at most 1 is good.
template <class Motion, class Exact>
double worst_of_bound(TestRuntime& runtime, double start, Motion motion, Exact exact) {
  REQUIRE(axisrt_reset(runtime.runtime, 0, start) == AXISRT_OK);
  double worst = 0;
  double distance = 0;
  for (int cycle = 0; cycle < 3000; ++cycle) {
    double const x = motion.next();
    double const y = runtime.step(x);
    auto const error = static_cast<double>(absolute(static_cast<Quad>(y) - exact(x)));
    distance = std::max(distance, std::fabs(y - x));
    double const bound = ulp(std::max(std::fabs(x), std::fabs(y))) / 2 + std::ldexp(distance, -42);
    worst = std::max(worst, error / bound);
  }
  return worst;
}

template <class Exact>
double worst_of_bound(TestRuntime& runtime, Exact exact) {
  return worst_of_bound(runtime, 1e9, RandomMotion(17), exact);
}

/// Setpoints whose increments add up to nothing, but not their magnitudes: the worst that can happen to sums
/// of them.
struct Alternating {
  int cycle = 0;
  double next() {
    ++cycle;
    return (cycle % 2 == 0 ? 1e5 : -1e5) / 3 + std::sin(cycle / 7.0);
  }
};

}  // namespace

TEST_CASE("a kernel is the convolution with its taps, within the promised accuracy") {
  for (Case const& one : cases()) {
    INFO(one.name);
    TestRuntime runtime(kernel_image(one.kernel));
    REQUIRE(runtime.status == AXISRT_OK);
    ExactKernel kernel(one.kernel.tails, 1e9);
    CHECK(worst_of_bound(runtime, [&](double x) { return kernel.step(x); }) <= 1);
  }
}

TEST_CASE("the accuracy holds for setpoints that alternate") {
  for (Case const& one : cases()) {
    INFO(one.name);
    TestRuntime runtime(kernel_image(one.kernel));
    ExactKernel kernel(one.kernel.tails, 0);
    CHECK(worst_of_bound(runtime, 0, Alternating{}, [&](double x) { return kernel.step(x); }) <= 1);
  }
}

TEST_CASE("FIR acts behind the other filters, HSC in front of them") {
  std::vector<ExactFilter> const filters = {exact::bandstop_of_order_3(20, T, 4), exact::delay(3),
                                            exact::with_share(exact::pt1(30, T), 0.5)};
  for (Case const& one : cases()) {
    INFO(one.name);
    TestRuntime fir(kernel_image(one.kernel, 2, filters));
    TestRuntime hsc(kernel_image(one.kernel, 1, filters));
    ExactKernel behind(one.kernel.tails, 1e9);
    ExactKernel before(one.kernel.tails, 1e9);
    ExactChain chain_before(filters, 1e9);
    ExactChain chain_behind(filters, 1e9);
    CHECK(worst_of_bound(fir, [&](double x) { return behind.step(chain_before.step(x)); }) <= 1);
    CHECK(worst_of_bound(hsc, [&](double x) { return chain_behind.step(before.step(x)); }) <= 1);
  }
}

TEST_CASE("behind the last increment the output is the setpoint, exactly and for good") {
  for (Case const& one : cases()) {
    INFO(one.name);
    TestRuntime runtime(kernel_image(one.kernel));
    axisrt_reset(runtime.runtime, 0, 1e9);
    RandomMotion motion(3);
    double x = 0;
    for (int cycle = 0; cycle < 500; ++cycle) static_cast<void>(runtime.step(x = motion.next()));
    for (std::size_t i = 0; i < one.kernel.tails.size(); ++i) static_cast<void>(runtime.step(x));
    for (int cycle = 0; cycle < 1000; ++cycle) REQUIRE(runtime.step(x) == x);
  }
}

TEST_CASE("a whole delay repeats the setpoints") {
  TestRuntime runtime(kernel_image(delay_kernel(7)));
  axisrt_reset(runtime.runtime, 0, 0);
  for (int cycle = 0; cycle < 300; ++cycle) {
    double const expected = cycle < 7 ? 0 : (cycle - 7.0) * (cycle - 7.0);
    REQUIRE(runtime.step(cycle * static_cast<double>(cycle)) == expected);
  }
}

TEST_CASE("a bad setpoint is the last good one, and the history runs on") {
  constexpr double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                            0x1p54};
  for (std::uint32_t const family : {1U, 2U}) {
    TestRuntime tested(kernel_image(moving_average(9), family, {exact::pt1(30, T)}));
    TestRuntime repeated(kernel_image(moving_average(9), family, {exact::pt1(30, T)}));
    tested.reset_all(100);
    repeated.reset_all(100);
    double last = 100;
    for (int cycle = 0; cycle < 200; ++cycle) {
      bool const is_bad = cycle % 11 == 5;
      if (!is_bad) last = 100 + 3.0 * cycle * cycle;
      double const y = tested.step(is_bad ? bad[cycle % 3] : last);
      REQUIRE(tested.status == (is_bad ? AXISRT_BAD_INPUT : AXISRT_OK));
      REQUIRE(y == repeated.step(last));
    }
  }
}

TEST_CASE("rebase moves the origin of an axis with a kernel and nothing else") {
  constexpr double offset = -3'600'000;
  for (std::uint32_t const family : {1U, 2U}) {
    TestRuntime plain(kernel_image(moving_average(9), family, {exact::pt1(30, T)}));
    TestRuntime rebased(kernel_image(moving_average(9), family, {exact::pt1(30, T)}));
    plain.reset_all(5e6);
    rebased.reset_all(5e6);
    for (int cycle = 0; cycle < 300; ++cycle) {
      if (cycle == 100) {
        REQUIRE(axisrt_rebase(rebased.runtime, 0, offset) == AXISRT_OK);
        for (int filter = 0; filter < 2; ++filter) {
          double const moved = plain.state().filter_output[filter] + offset;
          CHECK(std::fabs(rebased.state().filter_output[filter] - moved) <= 0x1p-29);
        }
      }
      double const x = 5e6 + 300.0 * cycle;
      double const shift = cycle >= 100 ? offset : 0;
      REQUIRE(std::fabs(rebased.step(x + shift) - (plain.step(x) + shift)) <= 0x1p-29);
    }
  }
}

TEST_CASE("a reset forgets the motion: the first output is the position") {
  for (std::uint32_t const family : {1U, 2U}) {
    TestRuntime runtime(kernel_image(moving_average(9), family, {exact::pt1(30, T)}));
    runtime.reset_all(1e9);
    for (int cycle = 0; cycle < 50; ++cycle) static_cast<void>(runtime.step(1e9 + 777.7 * cycle));
    runtime.reset_all(-123.456);
    for (int cycle = 0; cycle < 50; ++cycle) REQUIRE(runtime.step(-123.456) == -123.456);
  }
}

TEST_CASE("an axis with a kernel that was never reset repeats its input") {
  TestRuntime runtime(kernel_image(moving_average(9)));
  CHECK(runtime.step(55) == 55);
  CHECK(runtime.status == AXISRT_NOT_RESET);
  runtime.reset_all(60);
  CHECK(runtime.step(60) == 60);
}

TEST_CASE("the largest tails and setpoints stay finite") {
  for (std::uint32_t const family : {1U, 2U}) {
    TestRuntime runtime(kernel_image(kernel_of_tails(std::vector<double>(200, -64.0)), family,
                                     std::vector<ExactFilter>(3, exact::bandstop_of_order_3(20, T, 4))));
    REQUIRE(runtime.status == AXISRT_OK);
    runtime.reset_all(0);
    for (int cycle = 0; cycle < 2000; ++cycle) {
      REQUIRE(std::isfinite(runtime.step(cycle % 2 == 0 ? 0x1p53 : -0x1p53)));
    }
  }
}

}  // namespace kernel_test
