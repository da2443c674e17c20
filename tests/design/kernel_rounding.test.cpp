// Stored numbers are the nearest doubles of the mathematics: compared with the definitions evaluated tap by
// tap, each exponential, sine and cosine of its own, in twice the digits.
#include "design/kernels/kernel_design_def.hpp"
#include "support/catch.hpp"
#include "tests/design/kernel_specifications.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace kernel_rounding_test {

namespace {

using namespace axisc::design;
using Reference =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
using Taps = std::vector<Reference>;

Reference const pi = boost::math::constants::pi<Reference>();

Reference gaussian_tap(KernelSpecification const& s, int h, int k) {
  Reference const sigma = Reference(s.quality) * h / Reference(2.5);
  return exp(-(k / sigma) * (k / sigma) / 2);
}

Reference sinc_tap(Reference const& theta, int h, int k) {
  Reference const window = (54 + 46 * cos(pi * k / h)) / 100;
  return window * (k == 0 ? Reference(1) : Reference(sin(k * theta) / (k * theta)));
}

Taps convolved(Taps const& x, Taps const& y) {
  Taps product(x.size() + y.size() - 1, Reference(0));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j) product[i + j] += x[i] * y[j];
  return product;
}

Taps novib_taps(Reference const& theta, int half_box) {
  Reference sum = 1;
  for (int k = 1; k < half_box; ++k) sum += 2 * cos(k * theta);
  Taps box(2 * static_cast<std::size_t>(half_box) + 1, Reference(1));
  box.front() = box.back() = -sum / (2 * cos(half_box * theta));
  return convolved(box, box);
}

Taps taps_by_definition(KernelCase const& c) {
  KernelSpecification const& s = c.specification;
  int const h = static_cast<int>(tap_count(s, c.cycle_time) / 2);
  Reference const theta = 2 * pi * Reference(s.frequency.value) * c.cycle_time.nanoseconds / 1'000'000'000;
  Taps taps;
  if (s.type == KernelType::novib) {
    taps = novib_taps(theta, h / 2);
  } else {
    for (int k = -h; k <= h; ++k)
      taps.push_back(s.type == KernelType::gaussian        ? gaussian_tap(s, h, k)
                     : s.type == KernelType::windowed_sinc ? sinc_tap(theta, h, k)
                                                           : Reference(1));
  }
  Reference total = 0;
  for (Reference const& tap : taps) total += tap;
  Reference const share = Reference(s.share_percent) / 100;
  for (Reference& tap : taps) tap = share * tap / total;
  taps[taps.size() / 2] += 1 - share;
  return taps;
}

}  // namespace

TEST_CASE("every tail sum and tap is correctly rounded") {
  RandomKernels cases(20240612);
  for (int i = 0; i < 80; ++i) {
    KernelCase const c = cases.next();
    if (c.specification.type == KernelType::time_delay) continue;
    INFO(c);
    KernelDesign const kernel = design_kernel(c.specification, c.cycle_time);
    Taps const taps = taps_by_definition(c);
    REQUIRE(kernel.taps.size() == taps.size());
    std::size_t different = 0;
    Reference tail = 0;
    for (std::size_t j = taps.size(); j-- > 0;) {
      if (kernel.taps[j] != rounded(taps[j])) ++different;
      if (j < kernel.tail_sums.size() && kernel.tail_sums[j] != rounded(tail)) ++different;
      tail += taps[j];
    }
    CHECK(different == 0);
  }
}

TEST_CASE("recurrences keep 46 of 50 digits over the longest kernel") {
  using Exact =
      boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
  Exact const tolerance("1e-46");
  for (double const step : {1e-9, 4e-4, 0.1, 1.5, 3.1415}) {
    Phasor<Exact> phasor(Exact(step) / 2, Exact(step));
    for (int k = 0; k <= 100; ++k) {
      Exact const angle = Exact(step) / 2 + k * Exact(step);
      CHECK(abs(phasor.cosine() - cos(angle)) < tolerance);
      CHECK(abs(phasor.sine() - sin(angle)) < tolerance * (step < 0.01 ? angle : Exact(1)));
      phasor.advance();
    }
  }
  auto const c = gaussian<Exact>(100, Exact(3) / 10);
  for (int k = 0; k <= 100; ++k)
    CHECK(abs(c[static_cast<std::size_t>(k)] / exp(-Exact(k) * k / 288) - 1) < tolerance);
}

}  // namespace kernel_rounding_test
