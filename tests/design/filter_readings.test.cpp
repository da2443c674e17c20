// Filters in other readings than the documented one, beside the analogue filters of textbooks.
#include "design/filter_analysis.hpp"
#include "design/filter_kinds.hpp"
#include "support/catch.hpp"
#include "tests/design/specifications.hpp"

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

namespace filter_readings_test {

namespace {

using namespace axisc::design;
using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr CycleTime one_millisecond{1'000'000};
constexpr double T = 1e-3;

/// H(s), s in units of the characteristic angular frequency.
struct Analogue {
  FilterSpecification specification;
  std::function<Complex(Complex)> H;
};

std::vector<Analogue> analogue_filters() {
  double const sqrt2 = std::numbers::sqrt2;
  double const Q = 3;
  using enum FilterType;
  auto const butterworth = Prototype::butterworth;
  return {
      {filter_of(lowpass, butterworth, 2, 23), [=](Complex s) { return 1.0 / (s * s + sqrt2 * s + 1.0); }},
      {filter_of(lowpass, butterworth, 3, 31),
       [](Complex s) { return 1.0 / ((s + 1.0) * (s * s + s + 1.0)); }},
      {filter_of(highpass, butterworth, 2, 11), [=](Complex s) { return s * s / (s * s + sqrt2 * s + 1.0); }},
      {filter_of(allpass, butterworth, 2, 40),
       [=](Complex s) { return (s * s - sqrt2 * s + 1.0) / (s * s + sqrt2 * s + 1.0); }},
      {filter_of(bandstop, butterworth, 1, 48, Q),
       [=](Complex s) { return (s * s + 1.0) / (s * s + s / Q + 1.0); }},
      {filter_of(bandpass, butterworth, 1, 48, Q),
       [=](Complex s) { return (s / Q) / (s * s + s / Q + 1.0); }},
      {lag_of(pt2, 4000), [](Complex s) { return 1.0 / ((s + 1.0) * (s + 1.0)); }},
  };
}

double angular_frequency(FilterSpecification const& wanted) {
  return uses_time_constant(wanted.type) ? 1e6 / wanted.time_constant.value : 2 * pi * wanted.frequency.value;
}

void check_substitution(FilterReading reading, std::function<Complex(Complex z)> const& s_of_z) {
  for (auto analogue : analogue_filters()) {
    analogue.specification.reading = reading;
    for (auto const precision : {Precision::quick, Precision::exact}) {
      auto const made = design_filter(analogue.specification, one_millisecond, precision);
      for (double const frequency : {0.7, 5.0, 22.0, 48.5, 130.0, 410.0}) {
        Complex const z = std::polar(1.0, 2 * pi * frequency * T);
        Complex const expected = analogue.H(s_of_z(z) / angular_frequency(analogue.specification));
        INFO("type " << int(analogue.specification.type) << " at " << frequency << " Hz");
        CHECK(std::abs(response(made, {frequency}, one_millisecond) - expected) < 1e-9);
      }
    }
  }
}

}  // namespace

TEST_CASE("filters by the backward Euler method") {
  check_substitution(FilterReading::backward_euler, [](Complex z) { return (1.0 - 1.0 / z) / T; });
}

TEST_CASE("filters by the forward Euler method") {
  check_substitution(FilterReading::forward_euler, [](Complex z) { return (z - 1.0) / T; });
}

TEST_CASE("filters by the bilinear transform without pre-warping") {
  check_substitution(FilterReading::no_prewarping,
                     [](Complex z) { return 2 / T * (1.0 - 1.0 / z) / (1.0 + 1.0 / z); });
}

TEST_CASE("an analogue quality counts before the bilinear transform") {
  auto wanted = filter_of(FilterType::bandstop, Prototype::butterworth, 1, 180, 3);
  wanted.reading = FilterReading::analogue_quality;
  auto const made = design_filter(wanted, one_millisecond, Precision::exact);
  double const t = std::tan(pi * 180 * T);
  for (double const frequency : {20.0, 150.0, 200.0, 450.0}) {
    Complex const s{0, std::tan(pi * frequency * T) / t};
    CHECK(std::abs(response(made, {frequency}, one_millisecond) - (s * s + 1.0) / (s * s + s / 3.0 + 1.0)) <
          1e-9);
  }
}

TEST_CASE("matched poles of a lag fall by exp(-T/tau) a cycle") {
  for (auto const reading : {FilterReading::matched, FilterReading::matched_poles}) {
    auto wanted = lag_of(FilterType::pt1, 7000);
    wanted.reading = reading;
    CHECK(design_filter(wanted, one_millisecond, Precision::exact).pole_radius ==
          Approx(std::exp(-1.0 / 7)).epsilon(1e-14));
  }
}

TEST_CASE("matched filters have their poles and zeros at exp(sT)") {
  auto const z_of = [](Complex s, double frequency) { return std::exp(s * 2.0 * pi * frequency * T); };
  double const half_sqrt2 = std::numbers::sqrt2 / 2;
  auto wanted = filter_of(FilterType::lowpass, Prototype::butterworth, 2, 60);
  Complex const pole = z_of({-half_sqrt2, half_sqrt2}, 60);
  auto const denominator = [&](Complex z) { return (1.0 - pole / z) * (1.0 - std::conj(pole) / z); };
  Complex const z = std::polar(1.0, 2 * pi * 75 * T);

  wanted.reading = FilterReading::matched_poles;
  Complex const without = denominator(1) / denominator(z);
  CHECK(std::abs(response(design_filter(wanted, one_millisecond, Precision::exact), {75}, one_millisecond) -
                 without) < 1e-12);
  wanted.reading = FilterReading::matched;
  Complex const with = without * (1.0 + 1.0 / z) * (1.0 + 1.0 / z) / 4.0;
  CHECK(std::abs(response(design_filter(wanted, one_millisecond, Precision::exact), {75}, one_millisecond) -
                 with) < 1e-12);

  auto stop = filter_of(FilterType::bandstop, Prototype::butterworth, 1, 60, 2);
  stop.reading = FilterReading::matched;
  auto const stopped = design_filter(stop, one_millisecond, Precision::exact);
  CHECK(std::abs(response(stopped, {60}, one_millisecond)) < 1e-12);
  CHECK(std::abs(response(stopped, {0}, one_millisecond)) == Approx(1).epsilon(1e-12));
}

TEST_CASE("critical damping with its poles at fg_f0 is a cascade of lags") {
  auto wanted = filter_of(FilterType::lowpass, Prototype::critical_damping, 4, 25);
  wanted.reading = FilterReading::poles_at_frequency;
  auto const made = design_filter(wanted, one_millisecond, Precision::exact);
  // |1/(1 + j)|^4 = 1/4
  CHECK(std::abs(response(made, {25}, one_millisecond)) == Approx(0.25).epsilon(1e-12));
}

TEST_CASE("a reading that means nothing for a type leaves it as documented") {
  auto const is_kept = [](FilterSpecification wanted, FilterReading reading) {
    auto const documented = design_filter(wanted, one_millisecond, Precision::exact);
    wanted.reading = reading;
    CHECK(applied_reading(wanted) == FilterReading::documented);
    return design_filter(wanted, one_millisecond, Precision::exact).sections == documented.sections;
  };
  auto const butterworth = Prototype::butterworth;
  CHECK(is_kept(filter_of(FilterType::highpass, butterworth, 2, 20), FilterReading::matched));
  CHECK(is_kept(filter_of(FilterType::bandpass, butterworth, 2, 20, 2), FilterReading::matched_poles));
  CHECK(is_kept(filter_of(FilterType::lowpass, butterworth, 2, 20), FilterReading::poles_at_frequency));
  CHECK(is_kept(filter_of(FilterType::lowpass, butterworth, 2, 20), FilterReading::analogue_quality));
  CHECK(is_kept(lag_of(FilterType::time_delay, 2500), FilterReading::backward_euler));
}

TEST_CASE("filters for twice the cycle time are those of twice the frequency") {
  auto wanted = filter_of(FilterType::lowpass, Prototype::bessel, 3, 25);
  auto const faster = design_filter(filter_of(FilterType::lowpass, Prototype::bessel, 3, 50), one_millisecond,
                                    Precision::exact);
  wanted.cycle_time = CycleReading::twice;
  CHECK(design_filter(wanted, one_millisecond, Precision::exact).sections == faster.sections);
  wanted.frequency = {300};
  CHECK_FALSE(is_in_range(wanted, one_millisecond));
  wanted.cycle_time = CycleReading::half;
  CHECK(is_in_range(wanted, one_millisecond));
}

TEST_CASE("an unstable forward Euler filter says so by its pole radius") {
  auto wanted = filter_of(FilterType::lowpass, Prototype::butterworth, 4, 300);
  wanted.reading = FilterReading::forward_euler;
  CHECK(design_filter(wanted, one_millisecond, Precision::quick).pole_radius == 1);
}

TEST_CASE("half the gain at the frequency, in every prototype") {
  for (auto const prototype : every_prototype) {
    for (std::uint32_t const order : {1U, 2U, 5U}) {
      for (auto const type : {FilterType::lowpass, FilterType::highpass}) {
        auto wanted = filter_of(type, prototype, order, 35);
        wanted.reading = FilterReading::half_gain_at_frequency;
        INFO(int(prototype) << " of order " << order);
        CHECK(std::abs(response(design_filter(wanted, one_millisecond, Precision::exact), {35},
                                one_millisecond)) == Approx(0.5).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("Bessel filters that delay by 1/(2 pi f) at rest") {
  // In cycles 1/(2t), t = tan(pi f T), where s = (1/t)(1 - z^-1)/(1 + z^-1).
  for (std::uint32_t const order : {2U, 3U, 6U}) {
    auto wanted = filter_of(FilterType::lowpass, Prototype::bessel, order, 25);
    wanted.reading = FilterReading::bessel_delay;
    CHECK(design_filter(wanted, one_millisecond, Precision::exact).group_delay_cycles ==
          Approx(1 / (2 * std::tan(pi * 25 * T))).epsilon(1e-13));
  }
}

TEST_CASE("all-passes that turn the phase by half of its angle at the frequency") {
  for (auto const prototype : {Prototype::critical_damping, Prototype::bessel}) {
    for (std::uint32_t const order : {2U, 3U, 4U}) {
      auto wanted = filter_of(FilterType::allpass, prototype, order, 25);
      wanted.reading = FilterReading::allpass_phase;
      auto const turned =
          response(design_filter(wanted, one_millisecond, Precision::exact), {25}, one_millisecond);
      CHECK(std::abs(turned - std::polar(1.0, -pi / 2 * order)) < 1e-12);
    }
  }
}

TEST_CASE("a band-stop of critical damping with the quality of its poles is one of order 1, several times") {
  auto wanted = filter_of(FilterType::bandstop, Prototype::critical_damping, 3, 48, 3);
  wanted.reading = FilterReading::quality_of_poles;
  auto const cubed = design_filter(wanted, one_millisecond, Precision::exact);
  auto const single = design_filter(filter_of(FilterType::bandstop, Prototype::critical_damping, 1, 48, 3),
                                    one_millisecond, Precision::exact);
  for (double const frequency : {5.0, 44.0, 60.0, 300.0}) {
    auto const H = response(single, {frequency}, one_millisecond);
    CHECK(std::abs(response(cubed, {frequency}, one_millisecond) - H * H * H) < 1e-12);
  }
}

}  // namespace filter_readings_test
