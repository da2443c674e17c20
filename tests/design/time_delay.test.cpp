#include "design/filter_analysis.hpp"
#include "support/catch.hpp"
#include "tests/design/increment_filter.hpp"
#include "tests/design/specifications.hpp"

#include <cmath>
#include <vector>

namespace time_delay_test {

namespace {

using namespace axisc::design;

constexpr CycleTime one_millisecond{1'000'000};

FilterDesign delay_of(double cycles, Precision precision = Precision::exact) {
  return design_filter(lag_of(FilterType::time_delay, cycles * 1000), one_millisecond, precision);
}

}  // namespace

TEST_CASE("a fractional delay is an all-pass with exactly that delay at 0 Hz") {
  for (double cycles = 0.001; cycles < 6; cycles += 0.0437) {
    FilterDesign const design = delay_of(cycles);
    INFO(cycles << " cycles");
    REQUIRE(design.realisation == Realisation::sections);
    CHECK(design.group_delay_cycles == Approx(cycles).epsilon(1e-15));
    CHECK(chain_response({&design, 1}, {0}, one_millisecond).group_delay_s ==
          Approx(cycles * 1e-3).epsilon(1e-12));
    CHECK(design.pole_radius < 1);
    for (double const frequency : {0.1, 40.0, 250.0, 499.0}) {
      CHECK(std::abs(std::abs(response(design, {frequency}, one_millisecond)) - 1) < 1e-12);
    }
    std::uint32_t const order = cycles < 1.5 ? 1 : static_cast<std::uint32_t>(cycles + 0.5);
    CHECK(design.sections.size() == (order + 1) / 2);
  }
}

TEST_CASE("whole cycles are a pure delay, none passes through") {
  for (std::uint32_t cycles = 1; cycles <= 5; ++cycles) {
    for (double const off : {0.0, 9e-10, -9e-10}) {
      FilterDesign const design = delay_of(cycles + off);
      CHECK(design.realisation == Realisation::delay);
      CHECK(design.delay_cycles == cycles);
      CHECK(design.sections.empty());
      CHECK(design.group_delay_cycles == cycles);
      CHECK(design.pole_radius == 0);
    }
    CHECK(delay_of(cycles + 2e-9).realisation == Realisation::sections);
    CHECK(delay_of(cycles - 2e-9).realisation == Realisation::sections);
  }
  CHECK(delay_of(0).realisation == Realisation::pass_through);
  CHECK(delay_of(5e-10).realisation == Realisation::pass_through);
}

TEST_CASE("next to whole cycles the all-pass becomes the pure delay") {
  for (Precision const precision : {Precision::quick, Precision::exact}) {
    for (double const off : {3e-9, -3e-9, 1e-6, -1e-6}) {
      for (int cycles = 1; cycles <= 5; ++cycles) {
        IncrementFilter filter({delay_of(cycles + off, precision)});
        INFO(cycles << " cycles " << off);
        for (int n = 0; n < 20; ++n) {
          CHECK(std::abs(filter.step(1.0) - (n >= cycles ? 1 : 0)) < 10 * std::abs(off));
        }
      }
    }
  }
}

TEST_CASE("a pure delay has its delay at every frequency, and blends") {
  auto specification = lag_of(FilterType::time_delay, 3000);
  FilterDesign const whole = design_filter(specification, one_millisecond, Precision::exact);
  CHECK(chain_response({&whole, 1}, {123}, one_millisecond).group_delay_s == Approx(0.003));
  specification.share_percent = 50;
  FilterDesign const half = design_filter(specification, one_millisecond, Precision::exact);
  CHECK(half.group_delay_cycles == 1.5);
  // A comb: the two halves meet in opposite phase at 1/(2 · 3 T).
  CHECK(std::abs(response(half, {1e3 / 6}, one_millisecond)) < 1e-15);
  CHECK(step_figures({&half, 1}, 1000, 1e-4).settling_cycles == 3);
}

}  // namespace time_delay_test
