#include "design/kernels/kernel_analysis.hpp"
#include "design/kernels/kernel_design.hpp"
#include "design/kernels/kernel_shapes_def.hpp"
#include "support/catch.hpp"
#include "tests/design/kernel_specifications.hpp"

#include <cmath>
#include <numbers>

namespace kernel_novib_test {

namespace {

using namespace axisc::design;

double gain(KernelDesign const& kernel, double frequency, CycleTime cycle_time) {
  return std::abs(response(kernel, {frequency}, cycle_time));
}

double decibel(double gain) {
  return 20 * std::log10(gain);
}

}  // namespace

TEST_CASE("NoVib has no gain on its frequency and little beside it") {
  constexpr int frequencies = 50;
  for (std::uint32_t const nanoseconds : kernel_cycle_times) {
    CycleTime const cycle_time{nanoseconds};
    double const lowest = lowest_novib_frequency(cycle_time).value;
    double const highest = 0.99 * cycle_time.nyquist().value;
    for (int i = 0; i < frequencies; ++i) {
      double const f0 = lowest * std::pow(highest / lowest, double(i) / (frequencies - 1));
      KernelDesign const kernel = design_kernel(novib_of(f0), cycle_time);
      double const ratio = 1e9 / nanoseconds / f0;
      INFO(f0 << " Hz, fs/f0 = " << ratio);
      CHECK(kernel.tail_sums.size() <= longest_kernel_order);
      CHECK(gain(kernel, f0, cycle_time) < 1e-12);
      double const limit = ratio >= 3.03 ? -37 : -35.8;
      CHECK(decibel(gain(kernel, 0.9 * f0, cycle_time)) < limit);
      if (ratio > 2.2) CHECK(decibel(gain(kernel, 1.1 * f0, cycle_time)) < limit);
    }
  }
}

TEST_CASE("NoVib's order is 4 (m + 1), m = ceil((fs/f0 - 1)/2) - 1") {
  CycleTime const cycle_time{1'000'000};
  CHECK(novib_order({499}, cycle_time) == 4);
  CHECK(novib_order({334}, cycle_time) == 4);    // fs/f0 = 2.99
  CHECK(novib_order({333}, cycle_time) == 8);    // 3.003
  CHECK(novib_order({200}, cycle_time) == 8);    // 5
  CHECK(novib_order({199}, cycle_time) == 12);   // 5.03
  CHECK(novib_order({40}, cycle_time) == 48);    // 25
  CHECK(novib_order({10}, cycle_time) == 200);   // 100
  CHECK(novib_order({9.9}, cycle_time) == 204);  // 101.01
  for (double const unusable : {0.0, -1.0, 1e-300, std::nan("")})
    CHECK(novib_order({unusable}, cycle_time) == 4'000'000);
}

TEST_CASE("the longest NoVib kernel works, one step below its frequency it is too long") {
  for (std::uint32_t const nanoseconds :
       {62'500U, 125'000U, 333'333U, 400'000U, 1'000'000U, 3'000'000U, 4'000'000U}) {
    CycleTime const cycle_time{nanoseconds};
    Hertz const lowest = lowest_novib_frequency(cycle_time);
    CHECK(lowest.value == Approx(1e9 / nanoseconds / 101).epsilon(1e-15));
    CHECK(novib_order(lowest, cycle_time) == longest_kernel_order);
    CHECK(novib_order({std::nextafter(lowest.value, 0.0)}, cycle_time) == longest_kernel_order + 4);
    KernelDesign const kernel = design_kernel(novib_of(lowest.value), cycle_time);
    CHECK(kernel.half_width == longest_kernel_order / 2);
    CHECK(kernel.tail_sums.size() == longest_kernel_order);
    CHECK(gain(kernel, lowest.value, cycle_time) < 1e-12);
  }
}

TEST_CASE("where the period is an odd number of cycles the box needs no smaller edges") {
  for (std::uint32_t const nanoseconds : kernel_cycle_times) {
    CycleTime const cycle_time{nanoseconds};
    for (std::uint32_t n = 1; n <= 50; ++n) {
      double const f0 = 1e9 / (double(nanoseconds) * (2 * n + 1));
      CHECK(novib_order({f0}, cycle_time) == 4 * n);
      CHECK(novib_order({std::nextafter(f0, 0.0)}, cycle_time) == 4 * (n + 1));
      double const theta = 2 * std::numbers::pi * cycle_time.periods_in<double>({f0});
      CHECK(novib_edge_weight(n, theta) == Approx(1).epsilon(1e-11));
    }
  }
}

TEST_CASE("the weight of the edges is above 0 and at most 1") {
  for (double ratio = 2.0005; ratio < 101; ratio += 0.0371) {
    double const theta = 2 * std::numbers::pi / ratio;
    auto const n = static_cast<std::uint32_t>(std::ceil((ratio - 1) / 2));
    double const w = novib_edge_weight(n, theta);
    INFO("fs/f0 = " << ratio);
    CHECK(w > 0);
    CHECK(w <= 1 + 1e-12);
  }
}

TEST_CASE("a share leaves that much of the vibration") {
  CycleTime const cycle_time{1'000'000};
  KernelDesign const kernel = design_kernel(novib_of(53, 89), cycle_time);
  CHECK(gain(kernel, 53, cycle_time) == Approx(0.11).epsilon(1e-12));
}

}  // namespace kernel_novib_test
