// Peak gains of images are upper bounds of Σ|h|: no setpoint is amplified more, whatever rounding does, and
// also where a response is too long to be summed up.
#include "codegen/image_writer.hpp"
#include "codegen/proof.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace axisc::codegen::peak_gain_test {
namespace {

using design::CycleTime;
using design::FilterDesign;
using design::FilterSpecification;
using design::FilterType;
using design::IncrementSection;
using design::Prototype;

FilterSpecification filter(FilterType type, Prototype prototype, std::uint32_t order, double frequency,
                           double quality = 1) {
  return {.type = type, .prototype = prototype, .order = order, .frequency = {frequency}, .quality = quality};
}

std::vector<FilterDesign> chain_of(std::vector<FilterSpecification> const& specifications,
                                   CycleTime cycle_time) {
  std::vector<FilterDesign> chain;
  for (auto const& specification : specifications) {
    chain.push_back(design::design_filter(specification, cycle_time, design::Precision::exact));
  }
  return chain;
}

/// Impulse response of a chain in extended precision, by the transfer function H - 1 (or H) = (p + q z^-1)(1
/// - z^-1)/A(z) of the increment form in transposed direct form: neither the recursion nor the states of the
/// code under test.
class Impulse {
 public:
  explicit Impulse(std::vector<FilterDesign> const& chain) : chain_(chain) {
    for (FilterDesign const& one : chain) {
      sections_.emplace_back(one.sections.size());
      lines_.emplace_back(one.delay_cycles, 0.0L);
    }
  }

  long double next() {
    long double h = n_++ == 0 ? 1 : 0;
    for (std::size_t i = 0; i < chain_.size(); ++i) h = step(i, h);
    return h;
  }

 private:
  struct States {
    long double first = 0, second = 0;
  };

  /// y = b0 x + s1, s1' = b1 x - a1 y + s2, s2' = b2 x - a2 y, written for what the section adds to 1.
  static long double step_section(IncrementSection const& section, States& states, long double x) {
    long double const p = section.p, q = section.q, k = section.k, b = section.b;
    long double const y = p * x + states.first;
    states.first = (q - p) * x + (2 - k - b) * y + states.second;
    states.second = -q * x - (1 - b) * y;
    return y;
  }

  long double step(std::size_t i, long double x) {
    FilterDesign const& one = chain_[i];
    long double const share = one.share.filtered;
    long double y = x;
    if (one.realisation == design::Realisation::delay) {
      std::rotate(lines_[i].begin(), lines_[i].begin() + 1, lines_[i].end());
      y = std::exchange(lines_[i].back(), x);
    }
    for (std::size_t j = 0; j < one.sections.size(); ++j) {
      long double const added = step_section(one.sections[j], sections_[i][j], y);
      y = one.blocks_constant ? added : y + added;
    }
    return share * y + (1 - share) * x;
  }

  std::vector<FilterDesign> const& chain_;
  std::vector<std::vector<States>> sections_;
  std::vector<std::vector<long double>> lines_;
  std::uint64_t n_ = 0;
};

double summed_up(std::vector<FilterDesign> const& chain, std::uint64_t cycles) {
  Impulse impulse(chain);
  long double sum = 0;
  for (std::uint64_t n = 0; n < cycles; ++n) sum += std::abs(impulse.next());
  return static_cast<double>(sum);
}

}  // namespace

TEST_CASE("peak gains of random chains are not below the sum, and hardly above", "[proof]") {
  test::Random random(20261124);
  for (int i = 0; i < 60; ++i) {
    std::vector<FilterSpecification> specifications;
    for (std::uint32_t k = 1 + random.below(3); k > 0; --k) {
      FilterSpecification one = filter(
          static_cast<FilterType>(1 + random.below(5)), static_cast<Prototype>(1 + random.below(3)),
          1 + random.below(3), std::exp(random.between(std::log(4), std::log(400))), random.between(1, 10));
      if (random.below(4) == 0) one.share_percent = random.between(1, 100);
      if (random.below(6) == 0) one.type = FilterType::time_delay;
      specifications.push_back(one);
    }
    CAPTURE(i);
    auto const chain = chain_of(specifications, {1'000'000});
    double const sum = summed_up(chain, 60'000);
    double const stated = prove_chain(chain).peak_gain;
    CHECK(stated >= sum * (1 - 1e-15));
    CHECK(stated <= sum * (1 + 1e-7) + 1e-12);
    for (FilterDesign const& one : chain) {
      double const sum_of_one = summed_up({one}, 60'000);
      CHECK(prove_filter(one).peak_gain >= sum_of_one * (1 - 1e-15));
      CHECK(prove_filter(one).peak_gain <= sum_of_one * (1 + 1e-9));
    }
  }
}

TEST_CASE("what passes setpoints unchanged or later amplifies by 1, exactly", "[proof]") {
  FilterSpecification delay{.type = FilterType::time_delay, .time_constant = {7000}};
  CHECK(prove_chain(chain_of({delay, delay}, {1'000'000})).peak_gain == 1);
  delay.share_percent = 0;
  CHECK(prove_chain(chain_of({delay}, {1'000'000})).peak_gain == 1);
}

TEST_CASE("a peak gain that takes too long to sum up is an upper bound", "[proof]") {
  SECTION("a band-pass of 1.1e-6/T, then a PT2") {
    auto const chain = chain_of({filter(FilterType::bandpass, Prototype::butterworth, 3, 1.1e-3, 2.7),
                                 {.type = FilterType::pt2, .time_constant = {1e6}}},
                                {1'000'000});
    double const sum = summed_up(chain, 5'000'000);
    CHECK(sum > 1.4);
    CHECK(prove_chain(chain).peak_gain >= sum);
    CHECK(prove_chain(chain).peak_gain < 5 * sum);
  }
  SECTION("a notch of 0.05 Hz at 125 us") {
    auto const chain =
        chain_of({filter(FilterType::bandstop, Prototype::butterworth, 3, 0.05, 10)}, {125'000});
    double const sum = summed_up(chain, 8'000'000);
    CHECK(sum == Approx(3.357).epsilon(1e-3));
    CHECK(prove_chain(chain).peak_gain >= sum);
    CHECK(prove_chain(chain).peak_gain < 2 * sum);
  }
  SECTION("a low-pass at the limit of AX6001") {
    // Of critical damping: h >= 0, so that Σ|h| = H(1) = 1.
    for (double const frequency : {1e-5, 1e-6, 6e-8}) {
      auto const chain =
          chain_of({filter(FilterType::lowpass, Prototype::critical_damping, 6, frequency)}, {1'000'000});
      CAPTURE(frequency);
      CHECK(prove_chain(chain).peak_gain >= 1);
      CHECK(prove_chain(chain).peak_gain < 4);
    }
  }
}

TEST_CASE("setpoints within v are never implausible, also through a filter slower than any sum", "[proof]") {
  // Backwards through the signs of h, each increment adds to the last output's: it comes to Σ|h| v.
  CycleTime const cycle_time{1'000'000};
  std::vector<FilterSpecification> const specifications = {
      filter(FilterType::bandpass, Prototype::butterworth, 3, 1.1e-3, 2.7),
      {.type = FilterType::pt2, .time_constant = {1e6}}};
  machine::Machine machine = test::machine_with(specifications, cycle_time);
  machine.axes[0].velocity_limit = 500'000;
  auto const chain = chain_of(specifications, cycle_time);
  std::vector<bool> rises;
  Impulse impulse(chain);
  for (int n = 0; n < 3'000'000; ++n) rises.push_back(impulse.next() >= 0);

  image::RuntimeHost runtime = test::runtime_for(write_image(machine, {}));
  double const v = 5000;
  std::array<double, 1> x = {0};
  std::array<double, 1> y = {0};
  REQUIRE(runtime.reset_all(0) == AXISRT_OK);
  double largest = 0;
  std::uint64_t implausible = 0;
  for (std::size_t n = rises.size(); n-- > 0;) {
    double const before = y[0];
    x[0] += rises[n] ? v : -v;
    implausible += runtime.step(x, y) == AXISRT_OK ? 0 : 1;
    largest = std::max(largest, std::abs(y[0] - before));
  }
  CHECK(implausible == 0);
  CHECK(largest > 1.25 * v);
}

}  // namespace axisc::codegen::peak_gain_test
