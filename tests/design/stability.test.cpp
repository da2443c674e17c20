// What the image's loader demands holds for everything the ranges allow.
#include "design/filter_analysis.hpp"
#include "support/catch.hpp"
#include "tests/design/specifications.hpp"

#include <algorithm>
#include <cmath>

namespace stability_test {

namespace {

using namespace axisc::design;

bool loads(IncrementSection const& s) {
  return s.k > 0 && s.b > 0 && s.b < 2 && 4 - s.k - 2 * s.b > 0 && std::abs(s.p) <= 64 && std::abs(s.q) <= 64;
}

void check_design(Case const& c, Precision precision) {
  FilterDesign const design = design_filter(c.specification, c.cycle_time, precision);
  INFO(c);
  bool good = design.pole_radius < 1 && std::isfinite(design.group_delay_cycles);
  double previous = 0;
  for (IncrementSection const& section : design.sections) {
    good = good && loads(section);
    auto const [first, second] = poles(section);
    double const radius = std::max(std::abs(first), std::abs(second));
    // Double poles split by the square root of the rounding.
    good = good && radius > previous - 1e-6;
    previous = radius;
  }
  CHECK(good);
}

}  // namespace

TEST_CASE("ten thousand quick designs are stable and ordered by rising pole radius") {
  RandomCases cases(1);
  for (int i = 0; i < 10'000; ++i) check_design(cases.next(), Precision::quick);
}

TEST_CASE("some hundred exact designs are stable and ordered by rising pole radius") {
  RandomCases cases(2);
  for (int i = 0; i < 400; ++i) check_design(cases.next(), Precision::exact);
}

TEST_CASE("the ends of the ranges") {
  for (std::uint32_t const nanoseconds : {62'500U, 4'000'000U}) {
    CycleTime const cycle_time{nanoseconds};
    for (double const frequency : {0.1, 0.499 / cycle_time.seconds()}) {
      for (FilterType const type : every_type) {
        for (Prototype const prototype : every_prototype) {
          for (double const quality : {1.0, 10.0}) {
            auto specification = filter_of(type, prototype, highest_order(type), frequency, quality);
            specification.time_constant = {type == FilterType::time_delay ? 5.99 * cycle_time.microseconds()
                                                                          : 4294967295.0};
            check_design({specification, cycle_time}, Precision::exact);
          }
        }
      }
    }
  }
}

TEST_CASE("poles that rounding moves onto the unit circle are reported there") {
  CycleTime const cycle_time{1'000'000};
  for (FilterType const type : {FilterType::lowpass, FilterType::highpass, FilterType::bandstop}) {
    auto const specification =
        filter_of(type, Prototype::butterworth, 2, std::nextafter(cycle_time.nyquist().value, 0.0), 3);
    for (Precision const precision : {Precision::quick, Precision::exact}) {
      FilterDesign const design = design_filter(specification, cycle_time, precision);
      CHECK(design.pole_radius >= 1 - 1e-9);
    }
  }
}

TEST_CASE("the loader's test, and what rounding leaves of a design next to half the sampling rate") {
  CycleTime const cycle_time{1'000'000};
  RandomCases cases(5);
  for (int i = 0; i < 2000; ++i) {
    Case const c = cases.next();
    for (IncrementSection const& section :
         design_filter(c.specification, c.cycle_time, Precision::quick).sections) {
      CHECK(is_loadable(section) == loads(section));
    }
  }
  constexpr double pi = 3.14159265358979323846;
  for (std::uint32_t order = 1; order <= 6; ++order) {
    for (double const distance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
      double const f0 = 500 - 1000 * distance;
      auto const design =
          design_filter(filter_of(FilterType::lowpass, Prototype::critical_damping, order, f0), cycle_time,
                        Precision::exact);
      // The bilinear transform of the prototype: s = j tan(pi f T) / tan(pi f0 T), and tan(pi/2 - x) =
      // 1/tan(x).
      double const c = std::sqrt(std::exp2(1.0 / order) - 1);
      double worst = 0;
      for (double const times : {0.1, 0.5, 1.0, 3.0, 10.0, 100.0}) {
        if (distance * times >= 0.5) continue;
        double const s = std::tan(pi * distance) / std::tan(pi * distance * times);
        auto const expected = std::pow(1.0 / std::complex<double>(1, s * c), static_cast<int>(order));
        auto const found = response(design, {500 - 1000 * distance * times}, cycle_time);
        worst = std::max(worst, std::abs(found - expected));
      }
      INFO(order << " " << distance << " " << worst << " " << rounding_error(design));
      CHECK(worst <= rounding_error(design));
      CHECK(rounding_error(design) <= 1000 * worst + 1e-12);
    }
  }
  auto const beyond = design_filter(filter_of(FilterType::bandstop, Prototype::bessel, 3, 124.9),
                                    CycleTime{4'000'000}, Precision::exact);
  CHECK(std::isinf(rounding_error(beyond)));
}

TEST_CASE("the pole radius is that of the stored numbers") {
  RandomCases cases(4);
  int parted = 0;
  for (int i = 0; i < 300; ++i) {
    Case const c = cases.next();
    FilterDesign const design = design_filter(c.specification, c.cycle_time, Precision::exact);
    long double radius = 0;
    for (IncrementSection const& section : design.sections) {
      // z² + (k + b - 2) z + 1 - b = 0 has its roots at 1 - half ± sqrt(half² - k).
      long double const half = (static_cast<long double>(section.k) + section.b) / 2;
      long double const discriminant = half * half - section.k;
      bool const is_nearly_double = std::abs(discriminant) < 1e-14L * half * half;
      if (discriminant > 0 && is_nearly_double && discriminant > 1e-18L * half * half) ++parted;
      radius = std::max(radius, discriminant < 0 ? std::sqrt(1 - static_cast<long double>(section.b))
                                                 : std::abs(1 - half) + std::sqrt(discriminant));
    }
    INFO(c);
    CHECK(std::abs(static_cast<double>(radius - design.pole_radius)) <=
          2e-9 * (1 - design.pole_radius) + 1e-16);
  }
  CHECK(parted > 10);
}

TEST_CASE("quick and exact designs respond alike") {
  RandomCases cases(3);
  for (int i = 0; i < 300; ++i) {
    Case const c = cases.next();
    FilterDesign const quick = design_filter(c.specification, c.cycle_time, Precision::quick);
    FilterDesign const exact = design_filter(c.specification, c.cycle_time, Precision::exact);
    INFO(c);
    REQUIRE(quick.sections.size() == exact.sections.size());
    CHECK(quick.group_delay_cycles == Approx(exact.group_delay_cycles).epsilon(1e-9));
    // Rounding of the stored numbers parts double poles, which a quick design does not see.
    CHECK(quick.pole_radius == Approx(exact.pole_radius).margin(1e-7 * (1 - exact.pole_radius)));
    for (double const share : {1e-4, 0.01, 0.2, 0.8}) {
      Hertz const frequency{share * c.cycle_time.nyquist().value};
      auto const expected = response(exact, frequency, c.cycle_time);
      CHECK(std::abs(response(quick, frequency, c.cycle_time) - expected) <
            1e-9 * (1e-3 + std::abs(expected)));
    }
  }
}

}  // namespace stability_test
