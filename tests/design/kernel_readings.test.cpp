// Kernels in other readings than the documented one, beside taps by hand and their discrete Fourier
// transform.
#include "design/kernels/kernel_analysis.hpp"
#include "support/catch.hpp"
#include "tests/design/kernel_specifications.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace kernel_readings_test {

namespace {

using namespace axisc::design;

constexpr double pi = std::numbers::pi;
constexpr CycleTime one_millisecond{1'000'000};

KernelDesign read_as(KernelReading reading, KernelSpecification wanted) {
  wanted.reading = reading;
  return design_kernel(wanted, one_millisecond);
}

KernelSpecification gaussian_of(std::uint32_t order, double quality) {
  return {.type = KernelType::gaussian, .order = order, .quality = quality};
}

constexpr std::array every_reading{KernelReading::taps_n,
                                   KernelReading::taps_n_plus_1,
                                   KernelReading::half_width_rounded_down,
                                   KernelReading::order_is_half_width,
                                   KernelReading::gaussian_width_1,
                                   KernelReading::gaussian_width_2,
                                   KernelReading::gaussian_width_3,
                                   KernelReading::sinc_hann,
                                   KernelReading::sinc_blackman,
                                   KernelReading::sinc_no_window,
                                   KernelReading::novib_one_box,
                                   KernelReading::share_undelayed,
                                   KernelReading::share_ignored};

}  // namespace

TEST_CASE("orders as numbers of taps") {
  auto const taps = [](KernelReading reading, std::uint32_t order) {
    return read_as(reading, kernel_of(KernelType::moving_average, order)).taps;
  };
  CHECK(taps(KernelReading::taps_n, 4) == std::vector<double>(4, 0.25));
  CHECK(taps(KernelReading::taps_n, 1) == std::vector<double>{1});
  CHECK(taps(KernelReading::taps_n_plus_1, 3) == std::vector<double>(4, 0.25));
  CHECK(taps(KernelReading::half_width_rounded_down, 9).size() == 9);
  CHECK(taps(KernelReading::half_width_rounded_down, 1) == std::vector<double>{1});
  CHECK(taps(KernelReading::order_is_half_width, 8).size() == 17);
  CHECK(longest_order(KernelType::moving_average, KernelReading::order_is_half_width) == 100);
  CHECK(longest_order(KernelType::time_delay, KernelReading::order_is_half_width) == 100);
}

TEST_CASE("an even number of taps delays by half a cycle more or less, and shares its middle") {
  auto const kernel = read_as(KernelReading::taps_n, kernel_of(KernelType::moving_average, 4, 60));
  CHECK(kernel.group_delay_cycles == 1.5);
  CHECK(kernel.half_width == 0);
  CHECK(kernel.delay_cycles == 3);
  std::vector<double> const expected{0.15, 0.35, 0.35, 0.15};
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(kernel.taps[i] == Approx(expected[i]));
}

TEST_CASE("widths of the Gaussian and windows of the sinc") {
  auto const narrow = read_as(KernelReading::gaussian_width_3, gaussian_of(20, 0.5));
  CHECK(narrow.taps[10] / narrow.taps[13] == Approx(std::exp(0.5 * std::pow(3 / (0.5 * 10 / 3.0), 2))));
  auto const wide = read_as(KernelReading::gaussian_width_1, gaussian_of(20, 0.5));
  CHECK(wide.taps[10] / wide.taps[15] == Approx(std::exp(0.5)));
  auto const ratio = [](KernelReading reading) {
    auto const kernel = read_as(reading, sinc_of(20, 30));
    double const angle = 2 * pi * 0.03 * 4;
    return kernel.taps[14] / kernel.taps[10] / (std::sin(angle) / angle);
  };
  double const cosine = std::cos(0.4 * pi), twice = std::cos(0.8 * pi);
  CHECK(ratio(KernelReading::sinc_hann) == Approx(0.5 + 0.5 * cosine));
  CHECK(ratio(KernelReading::sinc_blackman) == Approx(0.42 + 0.5 * cosine + 0.08 * twice));
  CHECK(ratio(KernelReading::sinc_no_window) == Approx(1));
}

TEST_CASE("one box of NoVib has a single zero at its frequency and half the width") {
  auto const kernel = read_as(KernelReading::novib_one_box, novib_of(48));
  auto const documented = design_kernel(novib_of(48), one_millisecond);
  CHECK(kernel.taps.size() == documented.taps.size() / 2 + 1);
  CHECK(std::abs(response(kernel, {48}, one_millisecond)) < 1e-13);
  // Convolved with itself it is the documented kernel.
  auto const here = response(kernel, {31}, one_millisecond);
  CHECK(std::abs(here * here - response(documented, {31}, one_millisecond)) < 1e-12);
}

TEST_CASE("shares that are not delayed, or not there") {
  auto const whole = design_kernel(kernel_of(KernelType::moving_average, 6), one_millisecond);
  auto const undelayed =
      read_as(KernelReading::share_undelayed, kernel_of(KernelType::moving_average, 6, 70));
  CHECK(undelayed.taps.front() == Approx(0.3 + 0.7 / 7));
  CHECK(undelayed.taps.back() == Approx(0.1));
  CHECK(undelayed.group_delay_cycles == Approx(0.7 * 3));
  CHECK(read_as(KernelReading::share_ignored, kernel_of(KernelType::moving_average, 6, 70)).taps ==
        whole.taps);
  CHECK(read_as(KernelReading::share_ignored, kernel_of(KernelType::moving_average, 6, 0)).taps ==
        whole.taps);
}

TEST_CASE("every reading gives a kernel that images can hold, with the response of its taps") {
  RandomKernels random(20240805);
  for (int i = 0; i < 300; ++i) {
    auto c = random.next();
    for (auto const reading : every_reading) {
      c.specification.reading = reading;
      c.specification.order = std::min(c.specification.order, longest_order(c.specification.type, reading));
      auto const kernel = design_kernel(c.specification, c.cycle_time);
      INFO(c << " reading " << word_of(reading));
      std::size_t const tails = kernel.tail_sums.size();
      REQUIRE(kernel.taps.size() == tails + 1);
      CHECK(kernel.taps.size() == tap_count(c.specification, c.cycle_time));
      CHECK(kernel.group_delay_cycles == kernel_delay_cycles(c.specification, c.cycle_time));
      if (tails > 0) {
        // What a loader demands.
        CHECK((kernel.half_width == 0
                   ? kernel.delay_cycles == tails
                   : 2 * kernel.half_width == tails && kernel.delay_cycles == kernel.half_width));
      }
      CHECK(std::accumulate(kernel.taps.begin(), kernel.taps.end(), 0.0) == Approx(1).epsilon(1e-13));
      CHECK(std::accumulate(kernel.tail_sums.begin(), kernel.tail_sums.end(), 0.0) ==
            Approx(kernel.group_delay_cycles).epsilon(1e-11));
      for (double const part : {0.013, 0.21, 0.77}) {
        Hertz const frequency{part * c.cycle_time.nyquist().value};
        std::complex<double> sum = 0, moment = 0;
        for (std::size_t k = 0; k <= tails; ++k) {
          auto const term = kernel.taps[k] * std::polar(1.0, -pi * part * static_cast<double>(k));
          sum += term;
          moment += static_cast<double>(k) * term;
        }
        CHECK(std::abs(response(kernel, frequency, c.cycle_time) - sum) < 1e-12);
        if (std::abs(sum) < 1e-6) continue;
        CHECK(kernel_response(kernel, frequency, c.cycle_time).group_delay_s ==
              Approx((moment / sum).real() * c.cycle_time.seconds()).epsilon(1e-6).margin(1e-12));
      }
    }
  }
}

TEST_CASE("zeros of a moving average of four taps lie at a quarter and half of the sampling rate") {
  auto const kernel = read_as(KernelReading::taps_n, kernel_of(KernelType::moving_average, 4));
  auto const zeros = zero_frequencies(kernel, one_millisecond);
  REQUIRE(zeros.size() == 2);
  CHECK(zeros[0].value == Approx(250));
  CHECK(zeros[1].value == Approx(500));
}

TEST_CASE("kernels for another cycle time are those of a control with that cycle time") {
  for (auto wanted : {kernel_of(KernelType::moving_average, 40), kernel_of(KernelType::windowed_sinc, 41),
                      gaussian_of(30, 0.8), novib_of(28.4, 60), novib_of(120)}) {
    for (auto const reading : {KernelReading::documented, KernelReading::novib_one_box}) {
      wanted.reading = reading;
      wanted.cycle_time = CycleReading::documented;
      auto const slower = design_kernel(wanted, CycleTime{2'000'000});
      wanted.cycle_time = CycleReading::twice;
      auto const read = design_kernel(wanted, one_millisecond);
      INFO(int(wanted.type) << " at " << wanted.frequency.value << " Hz");
      CHECK(read.taps == slower.taps);
      CHECK(read.tail_sums == slower.tail_sums);
      CHECK(read.group_delay_cycles == slower.group_delay_cycles);
    }
  }
}

}  // namespace kernel_readings_test
