// Bounds of chains whose sums are known, and enclosures of what 113 bits find.
#include "bounded_image.hpp"
#include "runtime/bounds/pole_radius.hpp"
#include "runtime/exact_filter.hpp"

#include <cmath>
#include <vector>

namespace closed_forms_test {

using namespace axisc::test;
using axisc::runtime::bounds::BoundRecord;

namespace {

constexpr Quad T = Quad{1} / 1000;
constexpr double tightly = 1e-9;

/// A low-pass of first order,  y += a (x - y): h[n] = a (1 - a)^n.
FilterRecord first_order(double a) {
  FilterRecord filter;
  filter.sections = {{.p = a - 1, .q = 0, .k = a, .b = 1}};
  return filter;
}

void check_encloses(double bound, double value) {
  CHECK(bound >= value);
  CHECK(bound <= value * (1 + tightly) + 1e-9);
}

struct Sums {
  double gain = 0, distance = 0, highest = 0;
};

/// Of the filters that the image holds, in direct form: neither the recursion nor the states of the bounds.
Sums sums_of(std::vector<FilterRecord> const& records, std::uint32_t cycles) {
  std::vector<ExactFilter> filters;
  for (FilterRecord const& record : records) {
    ExactFilter filter{.sections = {},
                       .blocks_constant = record.blocks_constant != 0,
                       .delay_cycles = record.delay_cycles,
                       .is_delay = record.realisation == 2,
                       .share = record.share};
    for (SectionRecord const& stored : record.sections) {
      Quad const p = stored.p, q = stored.q, k = stored.k, b = stored.b;
      Quad const a1 = k + b - 2, a2 = 1 - b;
      DirectSection section{.b0 = p, .b1 = q - p, .b2 = -q, .a1 = a1, .a2 = a2};
      if (record.blocks_constant == 0) section = {1 + p, q - p + a1, a2 - q, a1, a2};
      filter.sections.push_back(section);
    }
    filters.push_back(filter);
  }
  ExactChain chain(filters, 0);
  Quad before = 0, gain = 0, distance = 0, highest = 0;
  for (std::uint32_t n = 0; n < cycles; ++n) {
    Quad const s = chain.step(1);
    gain += absolute(s - before);
    distance += absolute(s - 1);
    if (s - 1 > highest) highest = s - 1;
    before = s;
  }
  return {static_cast<double>(gain), static_cast<double>(distance), static_cast<double>(highest)};
}

}  // namespace

TEST_CASE("bounds of a low-pass of first order are those of its geometric series", "[bounds]") {
  for (double const a : {0.5, 0x1p-4, 0x1p-10}) {
    CAPTURE(a);
    BoundRecord const bound = bound_of({first_order(a)});
    CHECK(bound.flags == 0);
    check_encloses(bound.gain_high, 1);
    CHECK(bound.gain_low <= 1);
    CHECK(bound.gain_low >= 1 - tightly);
    check_encloses(bound.distance_high, (1 - a) / a);
    check_encloses(bound.overshoot_high, 0);
    CHECK(bound.radius_high == 1 - a);
    // |e| sums up to the distance, and it is 1 - a in the first cycle.
    CHECK(bound.state_increment == Approx((1 - a) / a).epsilon(1e-5));
    CHECK(bound.state_increment >= (1 - a) / a);
    CHECK(bound.rounding_increment >= 0x1p-53 * (1 - a) / a);
  }
}

TEST_CASE("delays and kernels have whole numbers as bounds", "[bounds]") {
  FilterRecord delay;
  delay.realisation = 2;
  delay.type = 10;
  delay.delay_cycles = 7;
  BoundRecord const bound = bound_of({delay});
  CHECK(bound.gain_low == 1);
  CHECK(bound.gain_high == 1);
  CHECK(bound.distance_high == 7);
  CHECK(bound.rounding_increment == 0);
  CHECK(bound.radius_high == 0);

  ImageRecord image = image_of({});
  image.kernels = {moving_average(5)};
  image.slots = {{.axis = 0, .kernel = 0, .history = 10}};
  auto const records = bounds_of(write_image(image));
  REQUIRE(records.size() == 2);
  check_encloses(records[1].gain_high, 1);
  // s[n] = (n + 1)/11:  10/11 + 9/11 + ... = 5
  check_encloses(records[1].distance_high, 5);
}

TEST_CASE("bounds enclose what 113 bits find, and are tight", "[bounds]") {
  FilterRecord shared = exact::with_share(exact::bandstop(40, T, 2), 0.75).record();
  FilterRecord delay = exact::with_share(exact::delay(9), 0.25).record();
  std::vector<std::vector<FilterRecord>> const chains = {
      {exact::bandstop(30, T, 3).record()},
      {exact::bandstop_of_order_3(25, T, 1).record(), exact::pt1(60, T).record()},
      {exact::lowpass(12, T, 4).record(), exact::allpass(33, T, 0.7).record()},
      {exact::pt2(20, T).record(), shared},
      {delay, exact::lowpass(80, T, 0.7).record()},
      {exact::lowpass(1, T, 1).record()}};
  for (auto const& chain : chains) {
    BoundRecord const bound = bound_of(chain);
    CAPTURE(chain.size(), bound.cycles);
    Sums const sums = sums_of(chain, 4 * bound.cycles);
    check_encloses(bound.gain_high, sums.gain);
    CHECK(bound.gain_low <= sums.gain);
    CHECK(bound.gain_low >= sums.gain * (1 - tightly));
    check_encloses(bound.distance_high, sums.distance);
    check_encloses(bound.overshoot_high, sums.highest);
  }
}

TEST_CASE("the gain of a filter that blocks the constant part is enclosed", "[bounds]") {
  for (auto const& filter : {exact::highpass(15, T, 0.7), exact::bandpass(20, T, 3)}) {
    BoundRecord const bound = bound_of({filter.record()});
    Sums const sums = sums_of({filter.record()}, 4 * bound.cycles);
    check_encloses(bound.gain_high, sums.gain);
    CHECK(bound.gain_low <= sums.gain);
    CHECK(bound.distance_high == 0);
    CHECK(bound.overshoot_high == 0);
  }
}

TEST_CASE("a gain next to nothing is enclosed as tightly", "[bounds]") {
  // What passes the first filter the second one takes away: roundings of the first count more than the rest.
  auto const bandpass = [](double frequency) { return exact::bandpass(frequency, T, 9).record(); };
  FilterRecord const shared = exact::with_share(exact::bandstop(31, T, 2), 0.37).record();
  std::vector<std::vector<FilterRecord>> const chains = {
      {bandpass(0.5), bandpass(180)},
      {bandpass(2), exact::delay(9).record(), bandpass(400)},
      {bandpass(0.25), shared, bandpass(440)},
      {exact::allpass(0.4, T, 4).record(), bandpass(0.5), exact::highpass(430, T, 0.7).record()}};
  for (auto const& chain : chains) {
    BoundRecord const bound = bound_of(chain);
    Sums const sums = sums_of(chain, 3 * bound.cycles);
    CAPTURE(chain.size(), bound.cycles, sums.gain);
    CHECK(bound.flags == 0);
    CHECK(bound.gain_low <= sums.gain);
    CHECK(bound.gain_high >= sums.gain);
    CHECK(bound.gain_high - bound.gain_low <= tightly * sums.gain);
  }
}

TEST_CASE("a kernel counts together with the filters, not as a product", "[bounds]") {
  // A moving average over a period of the ringing takes most of it away.
  ImageRecord image = image_of({exact::lowpass(50, T, 8).record()});
  image.kernels = {moving_average(10)};
  image.slots = {{.axis = 0, .kernel = 0, .history = 20}};
  auto const records = bounds_of(write_image(image));
  REQUIRE(records.size() == 2);
  CHECK(records[0].gain_high > 5);
  CHECK(records[1].gain_high < 2);
}

TEST_CASE("poles are within a radius, exactly", "[bounds]") {
  using axisc::runtime::bounds::poles_are_within;
  using axisc::runtime::bounds::smallest_radius;
  // Poles r and s: k = (1 - r)(1 - s), b = 1 - r s.
  CHECK(smallest_radius((1 - 0.75) * (1 - 0.5), 1 - 0.375) == 0.75);
  CHECK(smallest_radius((1 + 0.75) * (1 - 0.5), 1 + 0.375) == 0.75);
  CHECK(smallest_radius(1, 1) == 0);
  CHECK(smallest_radius(0.25, 1) == 0.75);
  // A double pole: a last digit less, and it is outside.
  double const k = 0x1p-20 * 0x1p-20;
  double const b = 1 - (1 - 0x1p-20) * (1 - 0x1p-20);
  CHECK(poles_are_within(1 - 0x1p-20, k, b));
  CHECK_FALSE(poles_are_within(std::nextafter(1 - 0x1p-20, 0), k, b));
  CHECK(smallest_radius(k, b) == 1 - 0x1p-20);
}

TEST_CASE("bounds of what no walk can follow are true, and of a sensible size", "[bounds]") {
  // |H| is 1 at half the sampling rate, or at 0 Hz: some setpoint is amplified as much. Three are in series.
  auto const three = [](FilterRecord const& filter) { return std::vector<FilterRecord>(3, filter); };
  for (double const frequency : {1e-4, 2e-6}) {
    BoundRecord const bound = bound_of(three(exact::highpass(frequency, T, 0.6).record()));
    CAPTURE(frequency);
    CHECK(bound.flags == 1);
    CHECK(bound.gain_high >= 1);
    CHECK(bound.gain_high < 1e13);
  }
  for (double const frequency : {499.99, 499.9993}) {
    BoundRecord const bound = bound_of(three(exact::lowpass(frequency, T, 0.6).record()));
    CAPTURE(frequency);
    CHECK(bound.flags == 1);
    CHECK(bound.gain_high >= 1);
    CHECK(bound.gain_high < 1e13);
  }
}

TEST_CASE("a filter that takes too long to follow has bounds that are true and say so", "[bounds]") {
  FilterRecord const filter = exact::bandstop(Quad{0.002}, T, 4).record();
  BoundRecord const bound = bound_of({filter});
  CHECK(bound.flags == 1);
  CHECK(bound.cycles == 1U << 22U);
  CHECK(bound.rest_cycles == 0);
  CHECK(bound.gain_high >= bound.gain_low);
  CHECK(bound.gain_high < 10);
}

}  // namespace closed_forms_test
