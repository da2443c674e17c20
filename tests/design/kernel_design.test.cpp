#include "design/kernels/kernel_design.hpp"

#include "support/catch.hpp"
#include "tests/design/kernel_filter.hpp"
#include "tests/design/kernel_specifications.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace kernel_design_test {

namespace {

using namespace axisc::design;

constexpr CycleTime one_millisecond{1'000'000};

KernelDesign design(KernelSpecification const& specification) {
  return design_kernel(specification, one_millisecond);
}

}  // namespace

TEST_CASE("order N has the half width ceil(N/2), 2h + 1 symmetrical taps and delays by h") {
  for (KernelType const type :
       {KernelType::moving_average, KernelType::gaussian, KernelType::windowed_sinc}) {
    for (std::uint32_t order = 1; order <= longest_kernel_order; order += order < 12 ? 1 : 17) {
      KernelDesign const kernel = design(kernel_of(type, order, order % 3 == 0 ? 70 : 100));
      std::uint32_t const h = (order + 1) / 2;
      CHECK(kernel.half_width == h);
      CHECK(kernel.delay_cycles == h);
      CHECK(kernel.group_delay_cycles == h);
      CHECK(kernel.tail_sums.size() == 2 * h);
      REQUIRE(kernel.taps.size() == 2 * h + 1);
      for (std::size_t k = 0; k <= h; ++k) CHECK(kernel.taps[k] == kernel.taps[2 * h - k]);
    }
  }
}

TEST_CASE("tail sums and taps agree, the tail sums mirror about the centre, and their sum is the delay") {
  RandomKernels cases(11);
  for (int i = 0; i < 200; ++i) {
    KernelCase const c = cases.next();
    KernelDesign const kernel = design_kernel(c.specification, c.cycle_time);
    INFO(c);
    auto const& S = kernel.tail_sums;
    double worst = 0, previous = 1;
    for (std::size_t j = 0; j < S.size(); ++j) {
      worst = std::max(worst, std::abs(previous - S[j] - kernel.taps[j]));
      previous = S[j];
      if (kernel.half_width > 0) worst = std::max(worst, std::abs(S[j] + S[S.size() - 1 - j] - 1));
    }
    worst = std::max(worst, std::abs(previous - kernel.taps.back()));
    CHECK(worst <= 2 * std::numeric_limits<double>::epsilon());
    CHECK(kernel.kernel_sum == 1);
    CHECK(std::accumulate(kernel.taps.begin(), kernel.taps.end(), 0.0) == Approx(1).epsilon(1e-14));
    CHECK(std::accumulate(S.begin(), S.end(), 0.0) == Approx(kernel.group_delay_cycles).epsilon(1e-13));
    CHECK(kernel.group_delay_cycles == kernel_delay_cycles(c.specification, c.cycle_time));
    CHECK(2 * kernel.half_width + 1 ==
          (c.specification.type == KernelType::time_delay ? 1 : tap_count(c.specification, c.cycle_time)));
  }
}

TEST_CASE("a moving average of order 4 by hand") {
  KernelDesign const kernel = design(kernel_of(KernelType::moving_average, 4));
  CHECK(kernel.taps == std::vector<double>(5, 0.2));
  CHECK(kernel.tail_sums == std::vector<double>{0.8, 0.6, 0.4, 0.2});
}

TEST_CASE("the share passes the rest through the centre tap") {
  KernelDesign const kernel = design(kernel_of(KernelType::moving_average, 4, 50));
  CHECK(kernel.taps == std::vector<double>{0.1, 0.1, 0.6, 0.1, 0.1});
  CHECK(kernel.tail_sums == std::vector<double>{0.9, 0.8, 0.2, 0.1});
  CHECK(kernel.group_delay_cycles == 2);
}

TEST_CASE("the Gaussian's width follows quality and half width: σ = quality h/2.5") {
  KernelSpecification specification = kernel_of(KernelType::gaussian, 40);
  KernelDesign const wide = design(specification);
  CHECK(wide.taps.front() / wide.taps[20] == Approx(std::exp(-0.5 * 2.5 * 2.5)).epsilon(1e-14));
  specification.quality = 0.5;
  KernelDesign const narrow = design(specification);
  CHECK(narrow.taps[10] / narrow.taps[20] == Approx(wide.taps.front() / wide.taps[20]).epsilon(1e-14));
}

TEST_CASE("taps too small for a double vanish, and nothing subnormal is stored") {
  KernelSpecification specification = kernel_of(KernelType::gaussian, 200);
  for (double const quality : {0.06, 1e-3, 1e-200, 5e-324}) {
    specification.quality = quality;
    KernelDesign const kernel = design(specification);
    for (double const tail : kernel.tail_sums) CHECK((tail == 0 || std::isnormal(tail)));
    for (double const tap : kernel.taps) CHECK((tap == 0 || std::isnormal(tap)));
    CHECK(kernel.tail_sums.front() == 1);
    CHECK(kernel.tail_sums.back() == 0);
  }
}

TEST_CASE("a time delay shifts by its order, blended undelayed") {
  for (std::uint32_t const order : {1U, 10U, 100U}) {
    KernelDesign const whole = design(kernel_of(KernelType::time_delay, order));
    CHECK(whole.half_width == 0);
    CHECK(whole.delay_cycles == order);
    CHECK(whole.group_delay_cycles == order);
    CHECK(whole.tail_sums == std::vector<double>(order, 1.0));
    KernelFilter filter(whole);
    for (std::uint32_t n = 0; n < 3 * order; ++n)
      CHECK(filter.step(n + 1.0) == (n < order ? 0 : n + 1 - order));

    KernelDesign const half = design(kernel_of(KernelType::time_delay, order, 25));
    CHECK(half.delay_cycles == order);
    CHECK(half.group_delay_cycles == order / 4.0);
    CHECK(half.tail_sums == std::vector<double>(order, 0.25));
    CHECK(half.taps.front() == 0.75);
    CHECK(half.taps.back() == 0.25);
  }
}

TEST_CASE("share 0 and order 0 pass the signal unchanged") {
  for (KernelType const type : every_kernel) {
    for (KernelSpecification const& specification : {kernel_of(type, 20, 0), kernel_of(type, 0)}) {
      if (type == KernelType::novib && specification.order == 0) continue;
      KernelDesign const kernel = design(specification);
      CHECK(passes_unchanged(specification));
      CHECK(kernel.tail_sums.empty());
      CHECK(kernel.taps == std::vector<double>{1});
      CHECK(kernel.delay_cycles == 0);
      CHECK(kernel.half_width == 0);
      CHECK(kernel.group_delay_cycles == 0);
      CHECK(kernel_delay_cycles(specification, one_millisecond) == 0);
    }
  }
  CHECK_FALSE(passes_unchanged(kernel_of(KernelType::novib, 0)));
}

TEST_CASE("equal settings in a moving average and a time delay keep a ramp in step") {
  for (std::uint32_t const order : {20U, 21U}) {
    KernelFilter average(design(kernel_of(KernelType::moving_average, order)));
    KernelFilter delay(design(kernel_of(KernelType::time_delay, (order + 1) / 2)));
    for (int n = 0; n < 500; ++n) {
      double const x = 123.456 * n;
      double const difference = average.step(x) - delay.step(x);
      if (n > 22) CHECK(std::abs(difference) < 1e-9);
    }
  }
}

TEST_CASE("constant input gives constant output, exactly, after any motion") {
  RandomKernels cases(12);
  for (int i = 0; i < 60; ++i) {
    KernelCase const c = cases.next();
    KernelFilter filter(design_kernel(c.specification, c.cycle_time));
    INFO(c);
    for (int n = 0; n < 50; ++n) filter.step(1e9 * std::sin(0.1 * n));
    double const position = 987654321.123;
    double y = 0;
    for (int n = 0; n < 202; ++n) y = filter.step(position);
    CHECK(y == position);
  }
}

TEST_CASE("a time becomes an order by rounding to the nearest cycle, and below one cycle it is off") {
  auto const order = [](double microseconds, std::uint32_t nanoseconds) {
    return order_of_time({microseconds}, {nanoseconds});
  };
  CHECK(order(0, 1'000'000) == std::nullopt);
  CHECK(order(999, 1'000'000) == std::nullopt);
  CHECK(order(1000, 1'000'000) == 1U);
  CHECK(order(1499, 1'000'000) == 1U);
  CHECK(order(1500, 1'000'000) == 2U);
  CHECK(order(2500, 1'000'000) == 3U);
  CHECK(order(16'000, 4'000'000) == 4U);
  CHECK(order(9250, 125'000) == 74U);
  CHECK(order(62, 62'500) == std::nullopt);
  CHECK(order(93, 62'500) == 1U);
  CHECK(order(94, 62'500) == 2U);
  CHECK(order(1, 333) == 3U);
  CHECK(order(4294967295.0, 62'500) == 68'719'477U);
  CHECK(order(1e30, 62'500) == 4'294'967'295U);
  CHECK(order(std::nan(""), 62'500) == std::nullopt);
  for (std::uint32_t n = 1; n < 400; ++n) {
    CHECK(order(n * 125 + 62, 125'000) == n);
    CHECK(order(n * 125 + 63, 125'000) == n + 1);
  }
}

TEST_CASE("equal specifications give equal kernels") {
  RandomKernels cases(13);
  for (int i = 0; i < 20; ++i) {
    KernelCase const c = cases.next();
    KernelDesign const first = design_kernel(c.specification, c.cycle_time);
    KernelDesign const second = design_kernel(c.specification, c.cycle_time);
    CHECK(first.tail_sums == second.tail_sums);
    CHECK(first.taps == second.taps);
  }
}

}  // namespace kernel_design_test
