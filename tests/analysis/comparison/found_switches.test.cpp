// #FILTER commands that nobody named are found in what they do to the output.
#include "analysis/comparison/found_switches.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace axisc::comparison::found_switches_test {
namespace {

constexpr ChangeOver lengths{.on = 120, .off = 40};

Configured averaging(bool on) {
  return {.cycle_time = design::CycleTime{1'000'000},
          .filters = {},
          .kernel = design::KernelSpecification{.type = design::KernelType::moving_average, .order = 30},
          .kernel_on = on};
}

/// Whole steps of 0.1 µm; the velocity jumps every 40 to 200 cycles.
std::vector<double> motion(std::mt19937_64& random, std::size_t cycles) {
  std::vector<double> values(cycles, 0.0);
  double position = 0;
  double velocity = 0;
  std::size_t next = 40;
  for (std::size_t n = 0; n < cycles; ++n) {
    if (n == next) {
      velocity = std::uniform_real_distribution<>(-400, 400)(random);
      next += std::uniform_int_distribution<std::size_t>(40, 200)(random);
    }
    position += velocity;
    values[n] = std::round(position);
  }
  return values;
}

/// A moving average of 31 values that is switched, from its definition, `lag` cycles late and rounded.
Signal control(std::vector<double> const& input, std::vector<KernelSwitch> const& switches, bool on,
               std::size_t lag) {
  std::vector<double> output(input.size(), 0.0);
  for (std::size_t n = lag; n < input.size(); ++n) {
    std::size_t const at = n - lag;
    double average = 0;
    for (std::size_t k = 0; k <= 30; ++k) average += input[at < k ? 0 : at - k] / 31;
    double share = on ? 1 : 0;
    for (auto const& one : switches) {
      if (at < one.cycle) continue;
      double const t =
          std::min(1.0, static_cast<double>(at - one.cycle + 1) / static_cast<double>(one.fade_cycles));
      double const w = t * t * t * (10 - 15 * t + 6 * t * t);
      share += w * ((one.kernel ? 1 : 0) - share);
    }
    output[n] = std::round(input[at] + share * (average - input[at]));
  }
  return output;
}

TEST_CASE("switches that nobody named are found to the cycle") {
  std::mt19937_64 random(11);
  for (int run = 0; run < 20; ++run) {
    auto const input = motion(random, 6000);
    bool const on = run % 2 == 0;
    auto const configured = averaging(on);
    std::vector<KernelSwitch> switches;
    bool state = on;
    for (std::size_t cycle = 700; cycle < 5000;
         cycle += std::uniform_int_distribution<std::size_t>(600, 1500)(random)) {
      state = !state;
      switches.push_back({.cycle = cycle,
                          .kernel = state ? configured.kernel : std::nullopt,
                          .fade_cycles = state ? lengths.on : lengths.off});
    }
    Recording const recording{.input = input,
                              .output = control(input, switches, on, static_cast<std::size_t>(run % 4)),
                              .gaps = {}};
    auto const found = found_switches(recording, configured, lengths);
    INFO(run);
    REQUIRE(found.size() == switches.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(std::abs(static_cast<double>(found[i].cycle) - static_cast<double>(switches[i].cycle)) <= 1);
      CHECK(found[i].kernel.has_value() == switches[i].kernel.has_value());
      CHECK(found[i].fade_cycles == switches[i].fade_cycles);
    }
    auto with = configured;
    with.switches = found;
    CHECK(compare(recording, readings(with)).verdict <= Verdict::delayed);
    CHECK(compare(recording, readings(configured)).verdict == Verdict::different);
  }
}

TEST_CASE("a filter that stays as it is is not switched") {
  std::mt19937_64 random(12);
  for (bool const on : {false, true}) {
    auto const input = motion(random, 4000);
    Recording const recording{.input = input, .output = control(input, {}, on, 2), .gaps = {}};
    CHECK(found_switches(recording, averaging(on), lengths).empty());
  }
  auto const input = motion(random, 4000);
  Configured const none{.cycle_time = design::CycleTime{1'000'000}, .filters = {}, .kernel = {}};
  CHECK(found_switches({.input = input, .output = input, .gaps = {}}, none, lengths).empty());
}

}  // namespace
}  // namespace axisc::comparison::found_switches_test
