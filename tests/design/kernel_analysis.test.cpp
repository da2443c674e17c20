#include "design/kernels/kernel_analysis.hpp"

#include "support/catch.hpp"
#include "tests/design/kernel_filter.hpp"
#include "tests/design/kernel_specifications.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace kernel_analysis_test {

namespace {

using namespace axisc::design;

constexpr CycleTime one_millisecond{1'000'000};

/// H = 1 - (1 - z^-1) Σ S_j z^-j of the stored numbers, in 50 digits.
std::complex<double> response_by_definition(KernelDesign const& kernel, Hertz frequency,
                                            CycleTime cycle_time) {
  using Exact = boost::multiprecision::cpp_bin_float_50;
  Exact const theta = 2 * boost::math::constants::pi<Exact>() * cycle_time.periods_in<Exact>(frequency);
  Exact re = 1, im = 0, cosine = 1, sine = 0;
  for (std::size_t j = 0; j < kernel.tail_sums.size(); ++j) {
    Exact const next_cosine = cos(theta * (j + 1)), next_sine = sin(theta * (j + 1));
    re -= kernel.tail_sums[j] * (cosine - next_cosine);
    im += kernel.tail_sums[j] * (sine - next_sine);
    cosine = next_cosine;
    sine = next_sine;
  }
  return {static_cast<double>(re), static_cast<double>(im)};
}

}  // namespace

TEST_CASE("the response is that of the stored tail sums") {
  RandomKernels cases(21);
  for (int i = 0; i < 20; ++i) {
    KernelCase const c = cases.next();
    KernelDesign const kernel = design_kernel(c.specification, c.cycle_time);
    INFO(c);
    double const nyquist = c.cycle_time.nyquist().value;
    for (double const frequency : {0.0, 1e-6, 0.01 * nyquist, 0.3 * nyquist, 0.97 * nyquist}) {
      std::complex<double> const h = response(kernel, {frequency}, c.cycle_time);
      CHECK(std::abs(h - response_by_definition(kernel, {frequency}, c.cycle_time)) < 1e-13);
    }
  }
}

TEST_CASE("next to 0 Hz gain and phase are accurate to the last digits") {
  RandomKernels cases(22);
  for (int i = 0; i < 100; ++i) {
    KernelCase const c = cases.next();
    KernelDesign const kernel = design_kernel(c.specification, c.cycle_time);
    INFO(c);
    double const theta = 2 * std::numbers::pi * 1e-9 * c.cycle_time.seconds();
    ResponsePoint const point = kernel_response(kernel, {1e-9}, c.cycle_time);
    CHECK(std::abs(point.magnitude - 1) < 1e-15);
    CHECK(point.phase_rad == Approx(-kernel.group_delay_cycles * theta).epsilon(1e-13));
    ResponsePoint const constant = kernel_response(kernel, {0}, c.cycle_time);
    CHECK(constant.magnitude == 1);
    CHECK(constant.phase_rad == 0);
    CHECK(constant.group_delay_s ==
          Approx(kernel_delay_cycles(c.specification, c.cycle_time) * c.cycle_time.seconds()).epsilon(1e-15));
  }
}

TEST_CASE("the group delay of a linear-phase kernel is h cycles at every frequency") {
  for (auto const& specification :
       {kernel_of(KernelType::moving_average, 21), kernel_of(KernelType::gaussian, 21, 40), sinc_of(21, 90),
        kernel_of(KernelType::time_delay, 11)}) {
    KernelDesign const kernel = design_kernel(specification, one_millisecond);
    for (double frequency = 0; frequency <= 500; frequency += 12.5)
      CHECK(kernel_response(kernel, {frequency}, one_millisecond).group_delay_s == 11 * 1e-3);
  }
}

TEST_CASE("the group delay of a blended time delay is the slope of its phase") {
  KernelDesign const kernel = design_kernel(kernel_of(KernelType::time_delay, 7, 30), one_millisecond);
  for (double const frequency : {1.0, 33.0, 71.0, 204.0}) {
    double const step = 1e-3;
    double const above = kernel_response(kernel, {frequency + step}, one_millisecond).phase_rad;
    double const below = kernel_response(kernel, {frequency - step}, one_millisecond).phase_rad;
    double const slope = -(above - below) / (2 * step * 2 * std::numbers::pi);
    CHECK(kernel_response(kernel, {frequency}, one_millisecond).group_delay_s == Approx(slope).epsilon(1e-6));
  }
  KernelDesign const half = design_kernel(kernel_of(KernelType::time_delay, 4, 50), one_millisecond);
  CHECK(std::isnan(kernel_response(half, {125}, one_millisecond).group_delay_s));
}

TEST_CASE("a kernel that passes the signal has gain 1, no delay and no zeros") {
  KernelDesign const kernel = design_kernel(kernel_of(KernelType::gaussian, 20, 0), one_millisecond);
  ResponsePoint const point = kernel_response(kernel, {123}, one_millisecond);
  CHECK(point.magnitude == 1);
  CHECK(point.phase_rad == 0);
  CHECK(point.group_delay_s == 0);
  CHECK(zero_frequencies(kernel, one_millisecond).empty());
  StepFigures const figures = step_figures(kernel, 1e-3);
  CHECK(figures.overshoot == 0);
  CHECK(figures.peak_gain == 1);
  CHECK(figures.settling_cycles == 0);
}

TEST_CASE("responses in series multiply, phases stay within a turn") {
  ResponsePoint const point = in_series({0.5, 3, 1e-3}, {0.25, 1, 2e-3});
  CHECK(point.magnitude == 0.125);
  CHECK(point.phase_rad == Approx(4 - 2 * std::numbers::pi));
  CHECK(point.group_delay_s == Approx(3e-3));
}

TEST_CASE("the zeros of a moving average are the multiples of fs/(2h + 1)") {
  for (std::uint32_t const order : {1U, 2U, 20U, 61U, 200U}) {
    KernelDesign const kernel = design_kernel(kernel_of(KernelType::moving_average, order), one_millisecond);
    auto const zeros = zero_frequencies(kernel, one_millisecond);
    REQUIRE(zeros.size() == kernel.half_width);
    for (std::size_t i = 0; i < zeros.size(); ++i)
      CHECK(zeros[i].value == Approx(1000.0 * double(i + 1) / double(kernel.taps.size())).epsilon(1e-12));
  }
}

TEST_CASE("the first zero of NoVib is the frequency it suppresses") {
  for (std::uint32_t const nanoseconds : kernel_cycle_times) {
    CycleTime const cycle_time{nanoseconds};
    double const lowest = lowest_novib_frequency(cycle_time).value;
    for (double factor = 1; factor < 50; factor *= 1.3) {
      KernelDesign const kernel = design_kernel(novib_of(lowest * factor), cycle_time);
      auto const zeros = zero_frequencies(kernel, cycle_time);
      INFO(lowest * factor << " Hz, T " << nanoseconds << " ns");
      REQUIRE_FALSE(zeros.empty());
      CHECK(zeros.front().value == Approx(lowest * factor).epsilon(1e-9));
      for (std::size_t i = 1; i < zeros.size(); ++i)
        CHECK(zeros[i].value - zeros[i - 1].value > 0.3 * lowest * factor);
    }
  }
  CHECK(zero_frequencies(design_kernel(novib_of(53, 80), one_millisecond), one_millisecond).empty());
}

TEST_CASE("zeros are places without gain, and what rounding makes is none") {
  RandomKernels cases(23);
  for (int i = 0; i < 40; ++i) {
    KernelCase const c = cases.next();
    KernelDesign const kernel = design_kernel(c.specification, c.cycle_time);
    INFO(c);
    auto const zeros = zero_frequencies(kernel, c.cycle_time);
    CHECK(zeros.size() <= kernel.half_width);
    for (Hertz const& zero : zeros) CHECK(std::abs(response(kernel, zero, c.cycle_time)) < 2e-12);
  }
  KernelSpecification narrow = kernel_of(KernelType::gaussian, 200);
  narrow.quality = 0.25;
  CHECK(zero_frequencies(design_kernel(narrow, one_millisecond), one_millisecond).empty());
}

TEST_CASE("a time delay that blends in equal halves is a comb") {
  KernelDesign const kernel = design_kernel(kernel_of(KernelType::time_delay, 4, 50), one_millisecond);
  auto const zeros = zero_frequencies(kernel, one_millisecond);
  REQUIRE(zeros.size() == 2);
  CHECK(zeros[0].value == Approx(125));
  CHECK(zeros[1].value == Approx(375));
  CHECK(zero_frequencies(design_kernel(kernel_of(KernelType::time_delay, 4, 49), one_millisecond),
                         one_millisecond)
            .empty());
}

TEST_CASE("step figures are those of the step response") {
  RandomKernels cases(24);
  for (int i = 0; i < 50; ++i) {
    KernelCase const c = cases.next();
    KernelDesign const kernel = design_kernel(c.specification, c.cycle_time);
    INFO(c);
    StepFigures const figures = step_figures(kernel, 0.01);
    KernelFilter filter(kernel);
    double highest = 0, path = 0, previous = 0;
    std::uint64_t settling = 0;
    for (std::uint64_t n = 0; n < 250; ++n) {
      double const y = filter.step(1.0);
      highest = std::max(highest, y);
      path += std::abs(y - previous);
      previous = y;
      if (std::abs(y - 1) > 0.01) settling = n + 1;
    }
    CHECK(figures.overshoot == Approx(std::max(0.0, highest - 1)).margin(1e-14));
    CHECK(figures.peak_gain == Approx(path).epsilon(1e-13));
    CHECK(figures.settling_cycles == settling);
  }
}

TEST_CASE("kernels without negative taps neither overshoot nor amplify; the windowed sinc does both") {
  for (auto const& specification :
       {kernel_of(KernelType::moving_average, 40), kernel_of(KernelType::gaussian, 40), novib_of(23.5),
        kernel_of(KernelType::time_delay, 40), kernel_of(KernelType::moving_average, 7, 33.3)}) {
    StepFigures const figures = step_figures(design_kernel(specification, one_millisecond), 0.01);
    CHECK(figures.overshoot == 0);
    CHECK(figures.peak_gain == 1);
  }
  StepFigures const sinc = step_figures(design_kernel(sinc_of(40, 100), one_millisecond), 0.01);
  CHECK(sinc.overshoot > 0.01);
  CHECK(sinc.peak_gain > 1.1);
}

}  // namespace kernel_analysis_test
