// A reading is named alone only where no other one explains the recording within its rounding.
#include "analysis/comparison/settings.hpp"
#include "analysis/comparison/verdict.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace axisc::comparison::named_alone_test {
namespace {

constexpr design::CycleTime cycle_time{1'000'000};

/// Six moves there and back, the way back at 77 % of the velocity, in whole units.
std::vector<double> moves(double velocity, double acceleration) {
  constexpr int travelling = 300;
  constexpr int resting = 60;
  std::vector<double> positions(100, 0.0);
  double position = 0;
  auto const advance = [&](double step) { positions.push_back(std::round(position += step)); };
  for (int move = 0; move < 6; ++move) {
    double const top = move % 2 == 0 ? velocity : -0.77 * velocity;
    auto const ramp = static_cast<int>(std::ceil(std::abs(top) / acceleration));
    auto const at = [&](int n) { return std::copysign(std::min(std::abs(top), acceleration * n), top); };
    for (int n = 1; n <= ramp; ++n) advance(at(n));
    for (int n = 0; n < travelling; ++n) advance(top);
    for (int n = ramp; n >= 1; --n) advance(at(n));
    for (int n = 0; n < resting; ++n) advance(0);
  }
  return positions;
}

std::vector<double> weighted(std::vector<double> const& values, std::vector<double> const& taps) {
  std::vector<double> sums(values.size());
  for (std::size_t n = 0; n < values.size(); ++n) {
    for (std::size_t k = 0; k < taps.size(); ++k) sums[n] += taps[k] * values[n < k ? 0 : n - k];
  }
  return sums;
}

/// A Butterworth low-pass of order 2 by the bilinear transform without pre-warping: s = 2/T (1 - z^-1)/(1 +
/// z^-1), and with c = π f T   y (1 + √2 c + c²) = c² (x + 2 x[-1] + x[-2]) - 2 (c² - 1) y[-1] - (1 - √2 c +
/// c²) y[-2].
std::vector<double> not_prewarped(std::vector<double> const& values, double frequency) {
  double const c = std::numbers::pi * frequency * cycle_time.seconds();
  double const root = std::numbers::sqrt2 * c;
  std::vector<double> answer(values.size(), values.front());
  for (std::size_t n = 2; n < values.size(); ++n) {
    double const in = c * c * (values[n] + 2 * values[n - 1] + values[n - 2]);
    answer[n] =
        (in - 2 * (c * c - 1) * answer[n - 1] - (1 - root + c * c) * answer[n - 2]) / (1 + root + c * c);
  }
  return answer;
}

Recording recorded(std::vector<double> const& in, std::vector<double> out) {
  for (double& value : out) value = std::round(value);
  return {.input = Signal(in), .output = Signal(out), .gaps = {}};
}

Configured kernel(design::KernelType type, std::uint32_t order) {
  return {.cycle_time = cycle_time,
          .filters = {},
          .kernel = design::KernelSpecification{.type = type, .order = order}};
}

std::vector<std::string> ids(std::vector<Departure> const& departures) {
  std::vector<std::string> found;
  for (auto const& departure : departures) found.emplace_back(departure.id);
  return found;
}

using Ids = std::vector<std::string>;
using design::KernelType;

TEST_CASE("readings that compute the same from these lists are named together, and no setting is written") {
  auto const in = moves(179, 21.3);
  // 41 taps: order 41 as N taps, and as half a width of 41/2 rounded down.
  auto const recording = recorded(in, weighted(in, std::vector<double>(41, 1.0 / 41)));
  auto const comparison = compare(recording, readings(kernel(KernelType::moving_average, 41)));
  CHECK(comparison.verdict == Verdict::different);
  REQUIRE(comparison.fitting.size() == 1);
  auto const& fitting = comparison.fitting.front().reading;
  CHECK(ids(fitting.departures) == Ids{"taps-n"});
  REQUIRE(fitting.equals.size() == 1);
  CHECK(ids(fitting.equals.front()) == Ids{"half-width-rounded-down"});
  CHECK_FALSE(settings_of(comparison, {}));
  auto const open = open_settings(comparison);
  REQUIRE(open.size() == 1);
  CHECK(open.front().key == "kernels");
  CHECK(open.front().possible == std::vector<std::string_view>{"taps-n", "half-width-rounded-down"});

  // 40 taps of order 40 are N taps only: half a width of 20 makes 41, as axisc does.
  auto const even = compare(recorded(in, weighted(in, std::vector<double>(40, 1.0 / 40))),
                            readings(kernel(KernelType::moving_average, 40)));
  REQUIRE(even.fitting.size() == 1);
  CHECK(ids(even.fitting.front().reading.departures) == Ids{"taps-n"});
  CHECK(even.fitting.front().reading.equals.empty());
  auto const settings = settings_of(even, {});
  REQUIRE(settings);
  CHECK(settings->readings.kernels == design::KernelReading::taps_n);
  CHECK(settings->open.empty());
}

TEST_CASE("a simple reading whose largest deviation no rounding makes gives way to two departures") {
  auto configured = kernel(KernelType::moving_average, 7);
  configured.filters = {{.type = design::FilterType::lowpass,
                         .prototype = design::Prototype::butterworth,
                         .order = 2,
                         .frequency = {84.2}}};
  auto const in = moves(40.3, 7.3);
  auto const out = weighted(not_prewarped(in, 84.2), std::vector<double>(7, 1.0 / 7));
  auto const comparison = compare(recorded(in, out), readings(configured));
  CHECK(comparison.verdict == Verdict::different);
  REQUIRE(comparison.fitting.size() == 1);
  auto const& fitting = comparison.fitting.front();
  CHECK(ids(fitting.reading.departures) == Ids{"no-prewarping", "taps-n"});
  // What the control computed is off by what its output was rounded by.
  CHECK(fitting.residual.largest < 0.501);
  REQUIRE(comparison.next);
  CHECK(ids(comparison.next->reading.departures) == Ids{"forward-euler"});
  CHECK(comparison.next->residual.largest > 1.1);

  // The filters are determined; of order 7 "N taps" and "half the width is N/2, rounded down" are the same.
  auto const settings = settings_of(comparison, {.kernels = design::KernelReading::order_is_half_width});
  REQUIRE(settings);
  CHECK(settings->readings == design::Readings{.filters = design::FilterReading::no_prewarping});
  REQUIRE(settings->open.size() == 1);
  CHECK(settings->open.front().key == "kernels");
}

TEST_CASE("a control that has none of the readings is not said to have the nearest") {
  // A Gaussian of 21 taps that is a little wider than any reading has it.
  std::vector<double> taps;
  double sum = 0;
  for (int k = -10; k <= 10; ++k) sum += taps.emplace_back(std::exp(-0.5 * std::pow(k * 2.48 / 10, 2)));
  for (double& tap : taps) tap /= sum;
  auto const in = moves(179, 21.3);
  auto const comparison =
      compare(recorded(in, weighted(in, taps)), readings(kernel(KernelType::gaussian, 21)));
  CHECK(comparison.verdict == Verdict::different);
  CHECK(comparison.fitting.empty());
  REQUIRE(comparison.next);
  // Both columns rounded by half a unit, and no tap is negative: at most one unit.
  CHECK(comparison.next->residual.largest > 1.1);
}

}  // namespace
}  // namespace axisc::comparison::named_alone_test
