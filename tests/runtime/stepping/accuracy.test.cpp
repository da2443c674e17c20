// The accuracy that the runtime promises, against the exact filter in quadruple precision: with coefficients
// that were never rounded, and states of the size of the position. T = 125 us, frequencies down to 1 Hz,
// positions near 1e9.
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace accuracy_test {

using namespace axisc::test;

namespace {

constexpr std::uint32_t cycle_time_ns = 125'000;
constexpr Quad T = Quad{1} / 8000;
constexpr double start = 995e6;
constexpr double target = 1e9;
constexpr int cycles_of_move = 8000;

/// Quintic from start to target in one second, on a grid of 1/16 unit.
double reference_move(int cycle) {
  double const t = std::min(1.0, static_cast<double>(cycle) / cycles_of_move);
  double const s = t * t * t * (10 + t * (6 * t - 15));
  return std::round((start + s * (target - start)) * 16) / 16;
}

double ulp(double x) {
  double const magnitude = std::fabs(x);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

struct Accuracy {
  double largest_error = 0;
  double largest_excess = 0;  ///< of the error over its bound; at most 0 is good
  double last_output = 0;
};

/// error <= ulp(max(|x|, |y|))/2 + 2^-42 D, D the largest distance between input and output (for chains that
/// block the constant part: of the input from its place of rest)
Accuracy measure(std::vector<ExactFilter> const& filters, int cycles, double (*input)(int)) {
  bool const blocks =
      std::any_of(filters.begin(), filters.end(), [](ExactFilter const& f) { return f.blocks_constant; });
  TestRuntime runtime(one_axis_image(filters, cycle_time_ns), cycle_time_ns);
  REQUIRE(runtime.status == AXISRT_OK);
  double const rest = input(0);
  ExactChain exact(filters, rest);
  REQUIRE(axisrt_reset(runtime.runtime, 0, rest) == AXISRT_OK);
  Accuracy accuracy;
  accuracy.largest_excess = -1;
  double distance = 0;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    double const x = input(cycle);
    double const y = runtime.step(x);
    Quad const expected = exact.step(x);
    auto const error = static_cast<double>(absolute(static_cast<Quad>(y) - expected));
    distance = std::max(distance, std::fabs(blocks ? x - rest : y - x));
    double const bound = ulp(std::max(std::fabs(x), std::fabs(y))) / 2 + std::ldexp(distance, -42);
    accuracy.largest_error = std::max(accuracy.largest_error, error);
    accuracy.largest_excess = std::max(accuracy.largest_excess, error - bound);
    accuracy.last_output = y;
  }
  return accuracy;
}

struct Case {
  std::string name;
  std::vector<ExactFilter> filters;
};

ExactFilter butterworth_lowpass_6(Quad f) {
  ExactFilter filter;
  for (int const i : {1, 3, 5}) {
    Quad const quality = 1 / (2 * cosine(i * quad_pi / 12));
    filter = exact::joined(filter, exact::lowpass(f, T, quality));
  }
  return filter;
}

std::vector<Case> cases() {
  using namespace exact;
  Quad const butterworth_1 = Quad{1} / (2 * cosine(quad_pi / 8));
  Quad const butterworth_2 = Quad{1} / (2 * cosine(3 * quad_pi / 8));
  Quad const half_root = square_root(Quad{2}) / 2;
  std::vector<Case> list;
  for (int const f : {1, 50}) {
    std::string const hertz = " at " + std::to_string(f) + " Hz";
    ExactFilter const lowpass_4 = joined(lowpass(f, T, butterworth_1), lowpass(f, T, butterworth_2));
    ExactFilter const highpass_3 = joined(first_order_highpass(f, T), highpass(f, T, 1));
    list.push_back({"band-stop of order 1" + hertz, {bandstop(f, T, 10)}});
    list.push_back({"band-stop of order 3" + hertz, {bandstop_of_order_3(f, T, 10)}});
    list.push_back({"low-pass of order 4" + hertz, {lowpass_4}});
    list.push_back(
        {"three low-passes of order 6" + hertz, std::vector<ExactFilter>(3, butterworth_lowpass_6(f))});
    list.push_back({"high-pass of order 3" + hertz, {highpass_3}});
    list.push_back({"band-pass of order 2" + hertz, {joined(bandpass(f, T, 10), bandpass(f, T, 10))}});
    list.push_back(
        {"all-pass of order 3" + hertz, {joined(first_order_allpass(f, T), allpass(f, T, half_root))}});
    list.push_back({"PT1" + hertz, {pt1(f, T)}});
    list.push_back({"PT2" + hertz, {pt2(f, T)}});
    list.push_back({"low-pass with a share" + hertz, {with_share(lowpass_4, 0.3)}});
    list.push_back({"high-pass with a share" + hertz, {with_share(highpass_3, 0.3)}});
    list.push_back(
        {"band-pass with a share, then low-pass" + hertz, {with_share(bandpass(f, T, 2), 0.7), lowpass_4}});
    list.push_back({"low-pass, then high-pass with a share, then delay with a share" + hertz,
                    {pt1(f, T), with_share(highpass_3, 0.9), with_share(delay(17), 0.4)}});
    list.push_back(
        {"two high-passes with a share" + hertz,
         {with_share(highpass(f, T, half_root), 0.1), with_share(first_order_highpass(f, T), 0.6)}});
    list.push_back({"low-pass, delay, band-stop" + hertz, {pt2(f, T), delay(3), bandstop(f, T, 4)}});
  }
  list.push_back({"Thiran of order 1", {thiran(1, Quad{13} / 10)}});
  list.push_back({"Thiran of order 2", {thiran(2, Quad{24} / 10)}});
  list.push_back({"Thiran next to a whole cycle", {thiran(2, Quad{2} + Quad{1} / 1000000)}});
  list.push_back({"delay", {delay(5)}});
  list.push_back({"delay of 100 cycles with a share", {with_share(delay(100), 0.35)}});
  list.push_back({"nothing", {}});
  return list;
}

/// Jumps of all sizes, positive and negative, whole and fractional.
double jumping_input(int cycle) {
  auto const n = static_cast<std::uint32_t>(cycle / 3);
  std::uint32_t const hash = (n * 2654435761U) ^ (n << 13U);
  double const size = std::ldexp(1.0, static_cast<int>(hash % 45U) - 15);
  return (hash & 1U) != 0 ? 1e9 / 3 - size / 3 : size / 7 - 4e8;
}

}  // namespace

TEST_CASE("the accuracy bound holds for every kind of filter during and after the reference move") {
  for (Case const& one : cases()) {
    Accuracy const accuracy = measure(one.filters, 3 * cycles_of_move / 2, reference_move);
    INFO(one.name << ": largest error " << accuracy.largest_error);
    CHECK(accuracy.largest_excess <= 0);
  }
}

TEST_CASE("the accuracy bound holds for jumps of every size") {
  for (Case const& one : cases()) {
    Accuracy const accuracy = measure(one.filters, 1000, jumping_input);
    INFO(one.name << ": largest error " << accuracy.largest_error);
    CHECK(accuracy.largest_excess <= 0);
  }
}

TEST_CASE("three band-stops of 1 Hz, Q 10, order 3 follow the reference move to 2.4e-7 units") {
  std::vector<ExactFilter> const filters(3, exact::bandstop_of_order_3(1, T, 10));
  Accuracy const accuracy = measure(filters, 3 * cycles_of_move, reference_move);
  INFO("largest error " << accuracy.largest_error);
  CHECK(accuracy.largest_error <= 2.4e-7);
  CHECK(accuracy.largest_excess <= 0);
}

TEST_CASE("a pure delay is exact to the last bit, whatever the positions are") {
  TestRuntime runtime(one_axis_image({exact::delay(4)}));
  REQUIRE(axisrt_reset(runtime.runtime, 0, jumping_input(0)) == AXISRT_OK);
  for (int cycle = 0; cycle < 2000; ++cycle) {
    REQUIRE(runtime.step(jumping_input(cycle)) == jumping_input(std::max(0, cycle - 4)));
  }
}

namespace {

/// A chain for a frequency; those of the lowest quality are the hardest on an input that alternates.
std::vector<ExactFilter> hard_chain(int kind, Quad f) {
  switch (kind) {
    case 0: return {exact::bandstop_of_order_3(f, T, 1)};
    case 1: return std::vector<ExactFilter>(3, exact::bandstop_of_order_3(f, T, 10));
    case 2: return {exact::lowpass(f, T, Quad{7} / 10), exact::allpass(f, T, 2)};
    case 3: return {exact::highpass(f, T, 1)};
    default: return {exact::allpass(f, T, Quad{7} / 10)};
  }
}

constexpr int hard_chains = 5;

/// Setpoints that no interpolator gives: alternating in every cycle or every other, noise, random
/// accelerations.
class HardInput {
 public:
  explicit HardInput(int kind) : kind_(kind) {}
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    double const noise = std::ldexp(static_cast<double>(state_ >> 33U), -30) - 1;  // -1 to 1
    ++cycle_;
    switch (kind_) {
      case 0: return position_ = (cycle_ & 1U) != 0 ? 1000 : -1000;
      case 1: return position_ = 5000 + ((cycle_ & 2U) != 0 ? 1e6 : -1e6);
      case 2: return position_ = 1e9 + 1000 * noise;
      default: velocity_ += 20 * noise; return position_ += velocity_;
    }
  }
  static constexpr int kinds = 4;

 private:
  int kind_;
  std::uint64_t state_ = 1;
  std::uint32_t cycle_ = 0;
  double velocity_ = 0, position_ = 0;
};

/// The largest error over  ulp + 2^-42 D + 2^-40 d  (next to the ends of the range  ulp + 2^-38 D + 2^-32 d).
double error_over_bound(std::vector<ExactFilter> const& filters, HardInput input, bool at_the_ends) {
  bool const blocks = filters[0].blocks_constant;
  TestRuntime runtime(one_axis_image(filters, cycle_time_ns), cycle_time_ns);
  REQUIRE(runtime.status == AXISRT_OK);
  double const rest = input.next();
  ExactChain exact(filters, rest);
  REQUIRE(axisrt_reset(runtime.runtime, 0, rest) == AXISRT_OK);
  double before = rest;
  double distance = 0;
  double increment = 0;
  double worst = 0;
  for (int cycle = 0; cycle < 1500; ++cycle) {
    double const x = input.next();
    double const y = runtime.step(x);
    auto const error = static_cast<double>(absolute(static_cast<Quad>(y) - exact.step(x)));
    distance = std::max(distance, blocks ? std::max(std::fabs(x - rest), std::fabs(y)) : std::fabs(y - x));
    increment = std::max(increment, std::fabs(x - before));
    before = x;
    double const bound = ulp(std::max(std::fabs(x), std::fabs(y))) +
                         std::ldexp(distance, at_the_ends ? -38 : -42) +
                         std::ldexp(increment, at_the_ends ? -32 : -40);
    worst = std::max(worst, error / bound);
  }
  return worst;
}

}  // namespace

TEST_CASE("the accuracy bound holds for setpoints that no interpolator gives, at every frequency") {
  for (double const periods_per_cycle : {1e-6, 1e-5, 1e-4, 1.25e-4, 1e-3, 1e-2, 0.1, 0.3, 0.4, 0.45, 0.475}) {
    bool const at_the_ends = periods_per_cycle < 1e-4 || periods_per_cycle > 0.4;
    Quad const f = static_cast<Quad>(periods_per_cycle) / T;
    for (int chain = 0; chain < hard_chains; ++chain) {
      for (int input = 0; input < HardInput::kinds; ++input) {
        INFO("f T " << periods_per_cycle << ", chain " << chain << ", input " << input);
        CHECK(error_over_bound(hard_chain(chain, f), HardInput(input), at_the_ends) <= 1);
      }
    }
  }
}

}  // namespace accuracy_test
