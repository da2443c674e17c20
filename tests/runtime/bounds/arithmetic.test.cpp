// How far double arithmetic goes at worst, and when it is at rest: bounds that searches do not exceed.
#include "bounded_image.hpp"
#include "runtime/exact_filter.hpp"
#include "runtime/test_runtime.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace arithmetic_test {

using namespace axisc::test;
using axisc::runtime::bounds::BoundRecord;

namespace {

constexpr Quad T = Quad{1} / 1000;

/// A section as the runtime executes it, in double or in 113 bits.
template <class Number>
struct Section {
  double p, g, k, b;
  Number e = 0, r = 0;

  void step(double d) {
    Number const de = Number(p) * Number(d) + r;
    e += de;
    r += Number(g) * Number(d) - Number(k) * e - Number(b) * de;
  }
};

/// Effect of a state's error on e some cycles later.
struct Weight {
  double of_e, of_r;
};

std::vector<Weight> weights_of(SectionRecord const& section, std::size_t cycles) {
  std::vector<Weight> weights;
  double e1 = 1, r1 = 0, e2 = 0, r2 = 1;
  auto const step = [&section](double& e, double& r) {
    e += r;
    r -= section.b * r + section.k * e;
  };
  for (std::size_t n = 0; n < cycles; ++n) {
    weights.push_back({e1, e2});
    step(e1, r1);
    step(e2, r2);
  }
  return weights;
}

/// Chooses the digits of the increments, all within 1, so that roundings push the last output the same way.
double worst_error_found(SectionRecord const& stored, std::size_t cycles) {
  double const g = stored.p + stored.q;
  Section<double> executed{.p = stored.p, .g = g, .k = stored.k, .b = stored.b};
  Section<Quad> exact{.p = stored.p, .g = g, .k = stored.k, .b = stored.b};
  std::vector<Weight> const weights = weights_of(stored, cycles);
  std::mt19937_64 random(20261127);
  std::uniform_real_distribution<double> digits(0.5, 1);
  for (std::size_t n = cycles; n-- > 0;) {
    Weight const weight = weights[n];
    // The sign that drives the states as far as they go.
    double const sign = weight.of_r * g + weight.of_e * stored.p >= 0 ? 1 : -1;
    double best = -1;
    auto best_executed = executed;
    auto best_exact = exact;
    for (int candidate = 0; candidate < 24; ++candidate) {
      double const d = sign * (candidate == 0 ? 1 : digits(random));
      auto tried = executed;
      auto followed = exact;
      tried.step(d);
      followed.step(d);
      double const error = static_cast<double>((Quad(tried.e) - followed.e) * Quad(weight.of_e) +
                                               (Quad(tried.r) - followed.r) * Quad(weight.of_r));
      if (error <= best && candidate > 0) continue;
      best = error;
      best_executed = tried;
      best_exact = followed;
    }
    executed = best_executed;
    exact = best_exact;
  }
  return std::abs(static_cast<double>(Quad(executed.e) - exact.e));
}

}  // namespace

TEST_CASE("a search for the worst roundings stays below the bound, within a factor of 50", "[bounds]") {
  std::vector<FilterRecord> const filters = {
      exact::bandstop(1, T, 10).record(), exact::lowpass(5, T, 1).record(),
      exact::bandstop(40, T, 2).record(), exact::allpass(3, T, 2).record(), exact::pt1(10, T).record()};
  for (FilterRecord const& filter : filters) {
    REQUIRE(filter.sections.size() == 1);
    BoundRecord const bound = bound_of({filter});
    double const found = worst_error_found(filter.sections[0], std::min(bound.cycles, 8000U));
    CAPTURE(bound.cycles, found, bound.rounding_increment / found);
    CHECK(found <= bound.rounding_increment);
    CHECK(found >= bound.rounding_increment / 50);
  }
}

TEST_CASE("the runtime stays within the bound of rounding, whatever the chain", "[bounds]") {
  std::vector<std::vector<ExactFilter>> const chains = {
      {exact::bandstop_of_order_3(20, T, 3), exact::lowpass(30, T, 0.7)},
      {exact::with_share(exact::bandstop(10, T, 5), 0.4), exact::delay(5), exact::pt2(40, T)},
      {exact::with_share(exact::delay(8), 0.5), exact::allpass(50, T, 1)}};
  std::mt19937_64 random(4711);
  std::uniform_real_distribution<double> increments(-1000, 1000);
  for (auto const& filters : chains) {
    std::vector<FilterRecord> records;
    for (auto const& filter : filters) records.push_back(filter.record());
    BoundRecord const bound = bound_of(records);
    TestRuntime runtime(write_image(image_of(records)));
    REQUIRE(runtime.status == AXISRT_OK);
    std::vector<ExactFilter> stored;
    for (FilterRecord const& record : records) stored.push_back(stored_filter(record));
    double x = 1e6;
    runtime.reset_all(x);
    ExactChain exact(stored, x);
    double largest = 0;
    for (int n = 0; n < 3000; ++n) {
      x += increments(random);
      double const y = runtime.step(x);
      Quad const wanted = exact.step(x);
      double const half_ulp = 0.5 * (std::nextafter(std::abs(y), HUGE_VAL) - std::abs(y));
      largest = std::max(largest, static_cast<double>(absolute(Quad(y) - wanted)) - half_ulp);
    }
    CHECK(largest <= 1000 * bound.rounding_increment);
  }
}

TEST_CASE("a chain is exactly at rest after the cycles that its bound says", "[bounds]") {
  std::vector<FilterRecord> const filters = {exact::bandstop(60, T, 2).record(),
                                             exact::with_share(exact::lowpass(90, T, 3), 0.7).record(),
                                             exact::delay(6).record()};
  ImageRecord image = image_of(filters);
  image.kernels = {moving_average(6)};
  image.slots = {{.axis = 0, .kernel = 0, .history = 12}};
  BoundRecord const bound = bounds_of(write_image(image)).at(1);
  REQUIRE(bound.rest_cycles > 0);
  REQUIRE(bound.rest_cycles < 20'000);
  TestRuntime runtime(with_bounds(image));
  REQUIRE(runtime.status == AXISRT_OK);
  std::mt19937_64 random(815);
  std::uniform_real_distribution<double> positions(-0x1p53, 0x1p53);
  runtime.reset_all(-0x1p53);
  for (int n = 0; n < 300; ++n) runtime.step(n % 2 == 0 ? 0x1p53 : -0x1p53);
  for (int n = 0; n < 300; ++n) runtime.step(positions(random));
  double const x = 12345.678;
  for (std::uint64_t n = 0; n < bound.rest_cycles; ++n) runtime.step(x);
  for (int n = 0; n < 2000; ++n) REQUIRE(runtime.step(x) == x);
}

}  // namespace arithmetic_test
