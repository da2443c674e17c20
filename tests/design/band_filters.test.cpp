// Band filters: centre exactly on f0, -3.0103 dB exactly f0/quality apart.
#include "design/filter_analysis.hpp"
#include "support/catch.hpp"
#include "tests/design/specifications.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace band_filters_test {

namespace {

using namespace axisc::design;

/// fu and fo with fo - fu = bandwidth and tan(π fu T) tan(π fo T) = tan²(π f0 T).
std::array<double, 2> band_edges(double f0, double bandwidth, CycleTime cycle_time) {
  double const T = cycle_time.seconds();
  double const t = std::tan(std::numbers::pi * f0 * T);
  double const difference = std::tan(std::numbers::pi * bandwidth * T) * (1 + t * t);
  double const sum = std::hypot(difference, 2 * t);
  double const lower = 2 * t * t / (sum + difference);
  double const fu = std::atan(lower) / (std::numbers::pi * T);
  return {fu, fu + bandwidth};
}

}  // namespace

TEST_CASE("band filters keep centre and bandwidth") {
  CycleTime const cycle_time = GENERATE(CycleTime{1'000'000}, CycleTime{125'000});
  for (Prototype const prototype : every_prototype) {
    for (std::uint32_t order = 1; order <= 3; ++order) {
      for (double const quality : {1.0, 2.5, 10.0}) {
        for (double const share_of_nyquist : {0.002, 0.1, 0.6, 0.9}) {
          double const f0 = share_of_nyquist * cycle_time.nyquist().value;
          auto const pass = design_filter(filter_of(FilterType::bandpass, prototype, order, f0, quality),
                                          cycle_time, Precision::exact);
          auto const stop = design_filter(filter_of(FilterType::bandstop, prototype, order, f0, quality),
                                          cycle_time, Precision::exact);
          INFO("prototype " << int(prototype) << " order " << order << " f0 " << f0 << " quality "
                            << quality);
          CHECK(pass.sections.size() == order);
          CHECK(stop.sections.size() == order);

          CHECK(std::abs(response(pass, {f0}, cycle_time) - 1.0) < 1e-12);
          CHECK(response(pass, {0}, cycle_time) == 0.0);
          CHECK(std::abs(response(pass, cycle_time.nyquist(), cycle_time)) < 1e-12);

          // The notch of order n falls as the n-th power: its depth there is what rounding leaves of one
          // section.
          CHECK(std::abs(response(stop, {f0}, cycle_time)) < 1e-13);
          CHECK(response(stop, {0}, cycle_time) == 1.0);
          // Wide bands high up have poles next to z = -1, where the increment form is no finer than double.
          CHECK(std::abs(response(stop, cycle_time.nyquist(), cycle_time) - 1.0) < 1e-11);

          for (double const edge : band_edges(f0, f0 / quality, cycle_time)) {
            CHECK(std::abs(std::norm(response(pass, {edge}, cycle_time)) - 0.5) < 1e-11);
            CHECK(std::abs(std::norm(response(stop, {edge}, cycle_time)) - 0.5) < 1e-11);
          }
        }
      }
    }
  }
}

TEST_CASE("each section of a band-pass blocks the constant part and amplifies little") {
  CycleTime const cycle_time{1'000'000};
  for (double const f0 : {0.1, 40.0, 400.0, 499.0}) {
    for (double const quality : {1.0, 3.0, 10.0}) {
      auto const design = design_filter(filter_of(FilterType::bandpass, Prototype::bessel, 3, f0, quality),
                                        cycle_time, Precision::exact);
      CHECK(design.blocks_constant);
      CHECK(design.dc_gain == 0);
      CHECK(design.group_delay_cycles == 0);
      for (IncrementSection const& section : design.sections) {
        CHECK(section.p == section.q);
        CHECK(section.p > 0);
        CHECK(section.p <= 1);
      }
    }
  }
}

}  // namespace band_filters_test
