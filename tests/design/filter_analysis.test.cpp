#include "design/filter_analysis.hpp"

#include "support/catch.hpp"
#include "tests/design/increment_filter.hpp"
#include "tests/design/specifications.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

namespace filter_analysis_test {

namespace {

using namespace axisc::design;

constexpr CycleTime one_millisecond{1'000'000};

std::vector<FilterDesign> mixed_chain() {
  auto highpass = filter_of(FilterType::highpass, Prototype::bessel, 2, 5);
  highpass.share_percent = 40;
  std::vector<FilterDesign> chain;
  for (auto const& specification : {filter_of(FilterType::bandstop, Prototype::butterworth, 2, 30, 2),
                                    highpass, lag_of(FilterType::time_delay, 2000)}) {
    chain.push_back(design_filter(specification, one_millisecond, Precision::exact));
  }
  return chain;
}

/// Plain summing up, without any thought about stopping early.
StepFigures measured(std::vector<FilterDesign> const& chain, std::uint64_t cycles, double final_value,
                     double tolerance) {
  IncrementFilter filter(chain);
  StepFigures figures;
  double previous = 0, highest = 0;
  for (std::uint64_t n = 0; n < cycles; ++n) {
    double const y = filter.step(1.0);
    figures.peak_gain += std::abs(y - previous);
    highest = std::max(highest, y);
    if (std::abs(y - final_value) > tolerance) figures.settling_cycles = n + 1;
    previous = y;
  }
  figures.overshoot = highest / final_value - 1;
  return figures;
}

}  // namespace

TEST_CASE("group delay is the derivative of the phase") {
  auto const chain = mixed_chain();
  for (double const frequency : {0.5, 7.0, 29.0, 31.0, 120.0, 480.0}) {
    double const h = 1e-4;
    double const before = chain_response(chain, {frequency - h}, one_millisecond).phase_rad;
    double const after = chain_response(chain, {frequency + h}, one_millisecond).phase_rad;
    double const turned = std::remainder(after - before, 2 * std::numbers::pi);
    CHECK(chain_response(chain, {frequency}, one_millisecond).group_delay_s ==
          Approx(-turned / (4 * std::numbers::pi * h)).epsilon(1e-6));
  }
  CHECK(chain_response(chain, {0}, one_millisecond).group_delay_s ==
        Approx(1e-3 * chain_delay_cycles(chain)).epsilon(1e-12));
}

TEST_CASE("a chain's response is the product of its filters'") {
  auto const chain = mixed_chain();
  std::complex<double> product = 1;
  for (auto const& filter : chain) product *= response(filter, {77}, one_millisecond);
  auto const point = chain_response(chain, {77}, one_millisecond);
  CHECK(std::abs(std::polar(point.magnitude, point.phase_rad) - product) < 1e-14);
  CHECK(chain_response({}, {77}, one_millisecond).magnitude == 1);
  CHECK(chain_delay_cycles({}) == 0);
}

TEST_CASE("where the magnitude is 0 there is no group delay") {
  for (auto const& [specification, frequency] :
       {std::pair{filter_of(FilterType::bandstop, Prototype::butterworth, 1, 30, 2), 30.0},
        std::pair{filter_of(FilterType::highpass, Prototype::bessel, 3, 30), 0.0},
        std::pair{filter_of(FilterType::bandpass, Prototype::bessel, 1, 30, 3), 0.0},
        std::pair{filter_of(FilterType::lowpass, Prototype::critical_damping, 4, 30), 500.0}}) {
    FilterDesign const design = design_filter(specification, one_millisecond, Precision::exact);
    CHECK(std::isnan(chain_response({&design, 1}, {frequency}, one_millisecond).group_delay_s));
    CHECK_FALSE(
        std::isnan(chain_response({&design, 1}, {0.99 * frequency + 0.01}, one_millisecond).group_delay_s));
  }
}

TEST_CASE("group delay at 0 Hz, with a share, also where one section blocks the constant part") {
  for (FilterType const type : every_type) {
    for (double const share : {100.0, 35.0}) {
      auto specification = filter_of(type, Prototype::bessel, 1, 30, 2);
      specification.time_constant = {type == FilterType::time_delay ? 2700.0 : 12000.0};
      specification.share_percent = share;
      FilterDesign const design = design_filter(specification, one_millisecond, Precision::exact);
      if (design.dc_gain == 0) continue;
      INFO("type " << int(type) << " share " << share);
      CHECK(chain_response({&design, 1}, {0}, one_millisecond).group_delay_s ==
            Approx(1e-3 * design.group_delay_cycles).epsilon(1e-11));
    }
  }
}

TEST_CASE("step figures agree with plain summing up") {
  auto const chain = mixed_chain();
  double const final_value = 0.6;
  StepFigures const expected = measured(chain, 5000, final_value, 1e-4);
  StepFigures const figures = step_figures(chain, 1'000'000, 1e-4);
  CHECK(figures.overshoot == Approx(expected.overshoot).epsilon(1e-11));
  CHECK(figures.peak_gain == Approx(expected.peak_gain).epsilon(1e-11));
  CHECK(figures.settling_cycles == expected.settling_cycles);
}

TEST_CASE("step figures of simple chains") {
  StepFigures const nothing = step_figures({}, 1000, 1e-4);
  CHECK(nothing.overshoot == 0);
  CHECK(nothing.peak_gain == 1);
  CHECK(nothing.settling_cycles == 0);

  // y[n] = 1 - (1 - k)^(n+1) (1 + p)/(1 - k): PT1 settles after ln(tolerance)/ln(pole) cycles.
  FilterDesign const lag = design_filter(lag_of(FilterType::pt1, 20000), one_millisecond, Precision::exact);
  StepFigures const slow = step_figures({&lag, 1}, 10'000, 1e-4);
  CHECK(slow.overshoot == 0);
  CHECK(slow.peak_gain == Approx(1).epsilon(1e-12));
  REQUIRE(slow.settling_cycles);
  CHECK(std::abs(static_cast<double>(*slow.settling_cycles) - std::log(1e-4) / std::log(lag.pole_radius)) <
        2);

  FilterDesign const highpass = design_filter(filter_of(FilterType::highpass, Prototype::butterworth, 2, 30),
                                              one_millisecond, Precision::exact);
  CHECK(step_figures({&highpass, 1}, 10'000, 1e-4).overshoot == 0);
  CHECK(step_figures({&highpass, 1}, 10'000, 1e-4).settling_cycles);
}

TEST_CASE("what must still settle inside of a chain need not show") {
  std::vector<FilterDesign> const chain = {
      design_filter(lag_of(FilterType::pt1, 5e6), one_millisecond, Precision::quick),
      design_filter(filter_of(FilterType::bandpass, Prototype::critical_damping, 1, 100), one_millisecond,
                    Precision::quick)};
  auto const settled = settling_cycles(chain, 40'000, 1e-4);
  REQUIRE(settled);
  CHECK(*settled <= 10'000);
  CHECK_FALSE(step_figures(chain, 40'000, 1e-4).settling_cycles);
  CHECK_FALSE(settling_cycles(std::span(chain).first(1), 40'000, 1e-4));
}

TEST_CASE("settling alone is what step figures say of it") {
  std::vector<FilterDesign> const all = mixed_chain();
  for (std::size_t length = 0; length <= all.size(); ++length) {
    std::span const chain = std::span(all).first(length);
    for (double const tolerance : {1e-2, 1e-4, 1e-6}) {
      for (std::uint64_t const longest : {10U, 100U, 1000U, 100'000U}) {
        CAPTURE(length, tolerance, longest);
        auto const figures = step_figures(chain, longest, tolerance);
        auto const settled = settling_cycles(chain, longest, tolerance);
        if (figures.settling_cycles) CHECK(settled == figures.settling_cycles);
        CHECK(settled.has_value() == (figures.within_from < longest));
      }
    }
  }
  // Slow ones in series, whose rests the last one amplifies.
  for (double const frequency : {0.5, 2.0, 7.0}) {
    std::vector<FilterDesign> chain;
    for (auto const& [type, prototype, order] :
         {std::tuple{FilterType::lowpass, Prototype::critical_damping, 6U},
          std::tuple{FilterType::bandstop, Prototype::butterworth, 3U},
          std::tuple{FilterType::bandpass, Prototype::butterworth, 3U}}) {
      chain.push_back(
          design_filter(filter_of(type, prototype, order, frequency), one_millisecond, Precision::exact));
    }
    CAPTURE(frequency);
    auto const settled = settling_cycles(chain, 1'000'000, 1e-4);
    CHECK(settled);
    CHECK(settled == step_figures(chain, 1'000'000, 1e-4).settling_cycles);
  }
}

TEST_CASE("overshoot alone is what step figures say of it") {
  for (FilterType const type : every_type) {
    for (double const frequency : {0.4, 4.0, 60.0, 300.0}) {
      for (Prototype const prototype :
           {Prototype::bessel, Prototype::butterworth, Prototype::critical_damping}) {
        FilterDesign const filter =
            design_filter(filter_of(type, prototype, 3, frequency, 4), one_millisecond, Precision::quick);
        for (std::vector<FilterDesign> const& chain :
             {std::vector{filter}, std::vector{filter, mixed_chain()[0]},
              std::vector{mixed_chain()[2], filter}}) {
          CAPTURE(type, prototype, frequency, chain.size());
          CHECK(step_overshoot(chain, 50'000) == step_figures(chain, 50'000, 1e-4).overshoot);
        }
      }
    }
  }
}

TEST_CASE("a chain settles before its bound") {
  std::vector<FilterDesign> filters;
  for (FilterType const type : every_type) {
    for (double const frequency : {0.3, 3.0, 40.0, 300.0}) {
      for (Prototype const prototype :
           {Prototype::bessel, Prototype::butterworth, Prototype::critical_damping}) {
        auto specification = filter_of(type, prototype, 3, frequency, 2);
        specification.time_constant = {type == FilterType::time_delay ? 4300.0 : 1e6 / frequency};
        specification.share_percent = frequency == 3.0 ? 30 : 100;
        filters.push_back(design_filter(specification, one_millisecond, Precision::quick));
      }
    }
  }
  // Each alone, twice (poles in one place), and behind one of another kind.
  for (std::size_t i = 0; i < filters.size(); ++i) {
    for (auto const& chain : {std::vector{filters[i]}, std::vector{filters[i], filters[i]},
                              std::vector{filters[(7 * i + 5) % filters.size()], filters[i],
                                          filters[(5 * i + 3) % filters.size()]}}) {
      for (double const tolerance : {1e-2, 1e-4}) {
        auto const settled = settling_cycles(chain, 100'000, tolerance);
        if (!settled) continue;
        CAPTURE(i, chain.size(), tolerance);
        CHECK(static_cast<double>(*settled) <= std::ceil(settling_bound(chain, tolerance)));
      }
    }
  }
  CHECK(settling_bound({}, 1e-4) >= 0);
}

TEST_CASE("a double pole that rounding parts gives no bound") {
  // Next to the Nyquist frequency, where one of the two comes to lie outside of the circle.
  constexpr CycleTime cycle_time{20'000};
  std::vector<FilterDesign> chain;
  chain.push_back(design_filter(filter_of(FilterType::lowpass, Prototype::critical_damping, 2, 24999.9976),
                                cycle_time, Precision::quick));
  chain.push_back(design_filter(filter_of(FilterType::lowpass, Prototype::butterworth, 1, 0.05), cycle_time,
                                Precision::quick));
  CHECK(settling_bound(chain, 1e-4) > 500'000);
  // What passes nothing in the end has nothing to settle to, but has to come to rest.
  std::vector<FilterDesign> blocked;
  blocked.push_back(design_filter(filter_of(FilterType::lowpass, Prototype::butterworth, 1, 1e-4), cycle_time,
                                  Precision::quick));
  blocked.push_back(design_filter(filter_of(FilterType::highpass, Prototype::butterworth, 1, 1e-4),
                                  cycle_time, Precision::quick));
  CHECK(settling_bound(blocked, 1e-4) > 0);
}

TEST_CASE("the bound of settling decides what filters of machines need") {
  constexpr double ten_seconds = 10'000;
  std::vector<FilterDesign> chain;
  chain.push_back(design_filter(filter_of(FilterType::lowpass, Prototype::butterworth, 6, 10),
                                one_millisecond, Precision::quick));
  CHECK(settling_bound(chain, 1e-4) < ten_seconds);
  chain.push_back(design_filter(filter_of(FilterType::bandstop, Prototype::critical_damping, 3, 25, 3),
                                one_millisecond, Precision::quick));
  CHECK(settling_bound(chain, 1e-4) < ten_seconds);
  FilterDesign const slow = design_filter(filter_of(FilterType::bandstop, Prototype::butterworth, 3, 0.1, 10),
                                          one_millisecond, Precision::quick);
  CHECK(settling_bound({&slow, 1}, 1e-4) > ten_seconds);
}

TEST_CASE("what does not settle in time is said so") {
  FilterDesign const slow = design_filter(filter_of(FilterType::bandstop, Prototype::butterworth, 3, 0.1, 10),
                                          one_millisecond, Precision::quick);
  CHECK_FALSE(step_figures({&slow, 1}, 10'000, 1e-4).settling_cycles);
  CHECK_FALSE(step_figures({&slow, 1}, 0, 1e-4).settling_cycles);
  FilterDesign const lag = design_filter(lag_of(FilterType::pt1, 20000), one_millisecond, Precision::exact);
  CHECK_FALSE(step_figures({&lag, 1}, 150, 1e-4).settling_cycles);
  CHECK(step_figures({&lag, 1}, 200, 1e-4).settling_cycles);
}

TEST_CASE("direct form and poles belong to the same section") {
  for (FilterType const type : every_type) {
    auto specification = filter_of(type, Prototype::butterworth, 3, 30, 2);
    specification.time_constant = {type == FilterType::time_delay ? 3600.0 : 12000.0};
    FilterDesign const design = design_filter(specification, one_millisecond, Precision::exact);
    for (IncrementSection const& section : design.sections) {
      DirectSection const direct = direct_form(section, design.blocks_constant);
      std::complex<double> const u = std::polar(1.0, -2 * std::numbers::pi * 0.041);
      FilterDesign const alone{.realisation = Realisation::sections,
                               .sections = {section},
                               .blocks_constant = design.blocks_constant};
      std::complex<double> const h =
          (direct.b0 + direct.b1 * u + direct.b2 * u * u) / (1.0 + direct.a1 * u + direct.a2 * u * u);
      CHECK(std::abs(h - response(alone, {41}, one_millisecond)) < 1e-12);

      auto const [first, second] = poles(section);
      CHECK(std::abs(first * second - direct.a2) < 1e-14);
      CHECK(std::abs(first + second + direct.a1) < 1e-14);
    }
  }
}

}  // namespace filter_analysis_test
