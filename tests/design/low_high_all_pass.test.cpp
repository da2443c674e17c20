// What manual and specification state about low-, high- and all-pass, PT1 and PT2.
#include "design/filter_analysis.hpp"
#include "support/catch.hpp"
#include "tests/design/specifications.hpp"

#include <cmath>
#include <numbers>

namespace low_high_all_pass_test {

namespace {

using namespace axisc::design;

constexpr CycleTime one_millisecond{1'000'000};
constexpr double half_power = 0.5;

double power(FilterSpecification const& specification, double frequency,
             CycleTime cycle_time = one_millisecond) {
  return std::norm(
      response(design_filter(specification, cycle_time, Precision::exact), {frequency}, cycle_time));
}

double overshoot(FilterSpecification const& specification) {
  FilterDesign const design = design_filter(specification, one_millisecond, Precision::exact);
  return step_figures({&design, 1}, 1'000'000, 1e-4).overshoot;
}

}  // namespace

TEST_CASE("low- and high-pass have -3.0103 dB at the characteristic frequency, and 1 and 0 at the ends") {
  for (Prototype const prototype : every_prototype) {
    for (std::uint32_t order = 1; order <= 6; ++order) {
      for (double const frequency : {0.5, 15.0, 250.0, 499.0}) {
        INFO("prototype " << int(prototype) << " order " << order << " at " << frequency << " Hz");
        auto const low = filter_of(FilterType::lowpass, prototype, order, frequency);
        auto const high = filter_of(FilterType::highpass, prototype, order, frequency);
        // Next to 0.5/T the poles come close to z = -1, where the increment form is no finer than double.
        double const tolerance = frequency < 400 ? 1e-12 : 1e-10;
        CHECK(std::abs(power(low, frequency) - half_power) < tolerance);
        CHECK(power(low, 0) == 1);
        CHECK(power(low, 500) < 1e-12);
        CHECK(std::abs(power(high, frequency) - half_power) < tolerance);
        CHECK(power(high, 0) == 0);
        CHECK(std::abs(power(high, 500) - 1) < tolerance);
      }
    }
  }
}

TEST_CASE("PT1 has -3.01 dB and PT2 -6.02 dB at 1/(2 pi tau)") {
  for (double const tau_us : {1000.0, 2500.0, 1e5}) {
    double const frequency = 1e6 / (2 * std::numbers::pi * tau_us);
    CHECK(std::abs(power(lag_of(FilterType::pt1, tau_us), frequency) - half_power) < 1e-13);
    CHECK(std::abs(power(lag_of(FilterType::pt2, tau_us), frequency) - half_power * half_power) < 1e-13);
  }
}

TEST_CASE("an all-pass has magnitude 1 everywhere and gain +1 at 0 Hz") {
  for (Prototype const prototype : every_prototype) {
    for (std::uint32_t order = 1; order <= 6; ++order) {
      auto const filter = filter_of(FilterType::allpass, prototype, order, 20);
      FilterDesign const design = design_filter(filter, one_millisecond, Precision::exact);
      CHECK(response(design, {0}, one_millisecond) == std::complex<double>(1, 0));
      for (double frequency = 0.01; frequency < 500; frequency *= 1.7) {
        CHECK(std::abs(std::abs(response(design, {frequency}, one_millisecond)) - 1) < 1e-12);
      }
    }
  }
}

TEST_CASE("overshoot: none with critical damping, little with Bessel, growing with Butterworth's order") {
  for (std::uint32_t order = 1; order <= 6; ++order) {
    for (double const frequency : {1.0, 20.0, 99.0}) {
      CHECK(overshoot(filter_of(FilterType::lowpass, Prototype::critical_damping, order, frequency)) < 1e-12);
    }
    double const bessel = overshoot(filter_of(FilterType::lowpass, Prototype::bessel, order, 2));
    if (order > 1) {
      CHECK(bessel > 0.001);
      CHECK(bessel < 0.01);
    } else {
      CHECK(bessel < 1e-12);
    }
  }
  auto const butterworth = [](std::uint32_t order) {
    return overshoot(filter_of(FilterType::lowpass, Prototype::butterworth, order, 1));
  };
  CHECK(butterworth(2) == Approx(0.043).margin(0.0005));
  CHECK(butterworth(4) == Approx(0.109).margin(0.001));
  CHECK(butterworth(6) == Approx(0.143).margin(0.0005));
}

TEST_CASE("a share blends the undelayed setpoint in, and none switches the filter off") {
  auto filter = filter_of(FilterType::highpass, Prototype::bessel, 3, 20);
  std::complex<double> const full =
      response(design_filter(filter, one_millisecond, Precision::exact), {33}, one_millisecond);
  filter.share_percent = 30;
  FilterDesign const part = design_filter(filter, one_millisecond, Precision::exact);
  CHECK(std::abs(response(part, {33}, one_millisecond) - (0.3 * full + 0.7)) < 1e-14);
  CHECK(part.dc_gain == 0.7);
  CHECK(part.share.filtered == 0.3);
  CHECK(part.share.direct == 0.7);
  // 0.3 and 0.7 are not what is meant: the two parts of "direct" are, to 32 digits.
  CHECK(std::abs(part.share.direct_low) > 1e-18);
  CHECK(std::abs(part.share.direct_low) < 1e-16);
  filter.share_percent = 0;
  CHECK(design_filter(filter, one_millisecond, Precision::exact).realisation == Realisation::pass_through);
}

}  // namespace low_high_all_pass_test
