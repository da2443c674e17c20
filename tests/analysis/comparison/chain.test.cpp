#include "analysis/comparison/chain.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axisc::comparison::chain_test {
namespace {

constexpr design::CycleTime cycle_time{1'000'000};

Link lag() {
  return link_of(design::design_filter({.type = design::FilterType::pt1, .time_constant = {10000}},
                                       cycle_time, design::Precision::quick));
}

TEST_CASE("a recording at rest stays where it is") {
  std::vector<double> const rest(50, 1234567.0);
  CHECK(respond({lag(), Link{.taps = {0.25, 0.5, 0.25}}}, rest) == rest);
}

TEST_CASE("taps answer a step with their sums") {
  std::vector<double> const step{1, 1, 2, 2, 2, 2};
  CHECK(respond({Link{.taps = {0.25, 0.5, 0.25}}}, step) == std::vector<double>{1, 1, 1.25, 1.75, 2, 2});
}

TEST_CASE("the backward Euler method makes of a lag what textbooks say") {
  // Without pre-warping a = T/(T + tau).
  design::FilterSpecification wanted{.type = design::FilterType::pt1, .time_constant = {10000}};
  wanted.reading = design::FilterReading::backward_euler;
  auto const euler = link_of(design::design_filter(wanted, cycle_time, design::Precision::quick));
  std::vector<double> const answer = respond({euler}, std::vector<double>{0, 1, 1, 1});
  double const a = 1.0 / 11;
  CHECK(std::abs(answer[1] - a) < 1e-9);
  CHECK(std::abs(answer[2] - (a + (1 - a) * a)) < 1e-9);
}

/// y[n] = b0 x[n] + b1 x[n-1] + b2 x[n-2] - a1 y[n-1] - a2 y[n-2] for the Butterworth filter of order 2 with
/// -3 dB at `frequency`: H(s) = 1/(s² + √2 s + 1), or s² above it for a high-pass, with
/// s = (1 - z⁻¹)/(K (1 + z⁻¹)), K = tan(π f T). From rest at the first input.
std::vector<double> butterworth(bool is_highpass, double frequency, std::vector<double> const& input) {
  long double const k = std::tan(std::acos(-1.0L) * frequency * 1e-3L);
  long double const norm = 1 / (1 + std::sqrt(2.0L) * k + k * k);
  long double const b0 = (is_highpass ? 1 : k * k) * norm;
  long double const b1 = is_highpass ? -2 * b0 : 2 * b0;
  long double const a1 = 2 * (k * k - 1) * norm;
  long double const a2 = (1 - std::sqrt(2.0L) * k + k * k) * norm;
  long double x1 = input.front();
  long double x2 = x1;
  long double y1 = is_highpass ? 0 : x1;
  long double y2 = y1;
  std::vector<double> answer;
  for (long double const x : input) {
    long double const y = b0 * x + b1 * x1 + b0 * x2 - a1 * y1 - a2 * y2;
    x2 = std::exchange(x1, x);
    y2 = std::exchange(y1, y);
    answer.push_back(static_cast<double>(y));
  }
  return answer;
}

TEST_CASE("filters answer as the recursion of the textbook, and a share mixes them with their input") {
  std::vector<double> input;
  for (int n = 0; n < 2000; ++n) input.push_back(1e5 + (n % 300 < 170 ? 7.0 * n : 4e3 - 3.0 * n));
  for (bool const is_highpass : {false, true}) {
    for (double const frequency : {3.0, 40.0, 310.0}) {
      for (double const share : {1.0, 0.6}) {
        auto link = link_of(design::design_filter(
            {.type = is_highpass ? design::FilterType::highpass : design::FilterType::lowpass,
             .prototype = design::Prototype::butterworth,
             .order = 2,
             .frequency = {frequency}},
            cycle_time, design::Precision::quick));
        link.share = share;
        auto const answer = respond({link}, input);
        auto const expected = butterworth(is_highpass, frequency, input);
        INFO(is_highpass << ' ' << frequency << ' ' << share);
        double largest = 0;
        for (std::size_t n = 0; n < input.size(); ++n) {
          double const mixed = input[n] + share * (expected[n] - input[n]);
          largest = std::max(largest, std::abs(answer[n] - mixed));
        }
        CHECK(largest < 1e-6);
      }
    }
  }
}

TEST_CASE("pieces of an input have the answer of the whole") {
  std::vector<double> input;
  for (int n = 0; n < 3000; ++n) input.push_back(n % 700 < 350 ? 5.0 * n : 1e6 - n);
  auto const blocking =
      link_of(design::design_filter({.type = design::FilterType::highpass, .order = 2, .frequency = {15}},
                                    cycle_time, design::Precision::quick));
  Chain const chain{lag(), Link{.taps = std::vector<double>(41, 1.0 / 41)}, blocking,
                    Link{.taps = {0.5, 0.5}}};
  auto const whole = respond(chain, input);
  Runner runner(chain);
  auto pieces = input;
  std::size_t length = 1;
  for (std::size_t first = 0; first < pieces.size(); first += length) {
    length = length * 3 % 601 + 1;
    runner.run(std::span(pieces).subspan(first, std::min(length, pieces.size() - first)));
  }
  for (std::size_t n = 0; n < whole.size(); ++n) CHECK(std::abs(pieces[n] - whole[n]) < 1e-6);
}

TEST_CASE("a kernel that is switched fades over from what it answered before") {
  std::vector<double> input;
  for (int n = 0; n < 400; ++n) input.push_back(n < 30 ? 100.0 : 100.0 + (n % 90 < 40 ? 3.0 * n : 900.0 - n));
  std::vector<double> const half(11, 1.0 / 11);
  std::vector<double> const pass{1.0};
  std::vector<double> const long_one(37, 1.0 / 37);
  Link const switched{.taps = pass,
                      .switches = {{.cycle = 60, .taps = half, .fade_cycles = 50},
                                   {.cycle = 150, .taps = long_one, .fade_cycles = 0},
                                   {.cycle = 250, .taps = pass, .fade_cycles = 80}}};
  auto const answer_of = [&](std::vector<double> const& taps, std::size_t n) {
    double sum = 0;
    for (std::size_t k = 0; k < taps.size(); ++k) sum += taps[k] * (n < k ? input.front() : input[n - k]);
    return sum;
  };
  // Quintic transition, 1/F in its first cycle.
  auto const w = [](std::size_t position, double length) {
    double const t = static_cast<double>(position) / length;
    return 6 * std::pow(t, 5) - 15 * std::pow(t, 4) + 10 * std::pow(t, 3);
  };
  auto const expected = [&](std::size_t n) {
    double const passed = input[n];
    double const averaged = answer_of(half, n);
    double const smoothed = answer_of(long_one, n);
    if (n < 60) return passed;
    if (n < 110) return passed + w(n - 59, 50) * (averaged - passed);
    if (n < 150) return averaged;
    if (n < 250) return smoothed;
    return n < 330 ? smoothed + w(n - 249, 80) * (passed - smoothed) : passed;
  };
  auto const whole = respond({switched}, input);
  Runner runner({switched});
  auto pieces = input;
  for (std::size_t first = 0; first < pieces.size(); first += 23) {
    runner.run(std::span(pieces).subspan(first, std::min<std::size_t>(23, pieces.size() - first)));
  }
  for (std::size_t n = 0; n < input.size(); ++n) {
    INFO(n);
    CHECK(std::abs(whole[n] - expected(n)) < 1e-9);
    CHECK(std::abs(pieces[n] - expected(n)) < 1e-9);
  }
  // A part of a recording begins in the state of its cycle.
  std::vector<double> const rest(40, 7.0);
  CHECK(respond({switched}, rest, 240) == rest);
  std::vector<double> step(20, 1.0);
  step.front() = 0;
  CHECK(respond({switched}, step, 160)[1] == Approx(1.0 / 37));
  CHECK(respond({switched}, step, 400)[1] == 1);
}

}  // namespace
}  // namespace axisc::comparison::chain_test
