#include "design/filter_kinds.hpp"

#include "support/catch.hpp"

#include <cstdint>
#include <limits>

namespace filter_kinds_test {

namespace {

using namespace axisc::design;

constexpr CycleTime one_millisecond{1'000'000};

FilterSpecification with_order(FilterType type, std::uint32_t order) {
  return {.type = type, .order = order};
}

FilterSpecification with_quality(FilterType type, double quality) {
  return {.type = type, .order = 1, .quality = quality};
}

FilterSpecification with_time(FilterType type, double microseconds) {
  return {.type = type, .time_constant = {microseconds}};
}

bool fits(FilterSpecification const& specification) {
  return is_in_range(specification, one_millisecond);
}

}  // namespace

TEST_CASE("every number of a type that is documented for standard filters has a row, and no other") {
  for (int number = -1; number < 256; ++number) {
    INFO(number);
    bool const documented = (number >= 1 && number <= 6) || number == 10 || number == 11;
    CHECK((find_filter_kind(number) != nullptr) == documented);
  }
}

TEST_CASE(
    "orders reach from 1 to 6, of band filters to 3, and mean nothing to types with an order of their own") {
  for (auto const type : {FilterType::lowpass, FilterType::highpass, FilterType::allpass}) {
    CHECK_FALSE(fits(with_order(type, 0)));
    CHECK(fits(with_order(type, 1)));
    CHECK(fits(with_order(type, 6)));
    CHECK_FALSE(fits(with_order(type, 7)));
  }
  for (auto const type : {FilterType::bandpass, FilterType::bandstop}) {
    CHECK(fits(with_order(type, 3)));
    CHECK_FALSE(fits(with_order(type, 4)));
  }
  for (auto const type : {FilterType::pt1, FilterType::pt2}) {
    CHECK(fits(with_order(type, 1)));
    CHECK(fits(with_order(type, 100)));
    CHECK_FALSE(fits(with_order(type, 0)));
  }
}

TEST_CASE("a characteristic frequency lies between 0 and half the sampling frequency") {
  FilterSpecification wanted{.type = FilterType::lowpass};
  for (double const good : {1e-3, 499.999}) {
    wanted.frequency = {good};
    CHECK(fits(wanted));
  }
  for (double const bad : {0.0, -1.0, 500.0, std::numeric_limits<double>::quiet_NaN()}) {
    wanted.frequency = {bad};
    CHECK_FALSE(fits(wanted));
    wanted.type = FilterType::pt1;
    CHECK(fits(wanted));
    wanted.type = FilterType::lowpass;
  }
}

TEST_CASE("qualities of band filters reach from 1 to 10") {
  for (auto const type : {FilterType::bandpass, FilterType::bandstop}) {
    CHECK_FALSE(fits(with_quality(type, 0.999)));
    CHECK(fits(with_quality(type, 1)));
    CHECK(fits(with_quality(type, 10)));
    CHECK_FALSE(fits(with_quality(type, 10.001)));
  }
  CHECK(fits(with_quality(FilterType::lowpass, 0)));
}

TEST_CASE("a lag lasts one cycle at least, a delay stays below six") {
  for (auto const type : {FilterType::pt1, FilterType::pt2}) {
    CHECK_FALSE(fits(with_time(type, 999)));
    CHECK(fits(with_time(type, 1000)));
    CHECK(fits(with_time(type, 1e9)));
  }
  CHECK_FALSE(fits(with_time(FilterType::time_delay, -1)));
  CHECK(fits(with_time(FilterType::time_delay, 0)));
  CHECK(fits(with_time(FilterType::time_delay, 5999)));
  CHECK_FALSE(fits(with_time(FilterType::time_delay, 6000)));
  CHECK(fits(with_time(FilterType::lowpass, 0)));
}

TEST_CASE("a share is a part of the whole") {
  for (double const share : {-0.1, 100.1}) {
    CHECK_FALSE(fits({.type = FilterType::lowpass, .share_percent = share}));
  }
  for (double const share : {0.0, 100.0}) {
    CHECK(fits({.type = FilterType::lowpass, .share_percent = share}));
  }
}

TEST_CASE("a number without a row uses nothing") {
  auto const unknown = static_cast<FilterType>(0);
  CHECK_FALSE(uses_frequency(unknown));
  CHECK_FALSE(uses_prototype(unknown));
  CHECK_FALSE(uses_quality(unknown));
  CHECK_FALSE(uses_time_constant(unknown));
  CHECK_FALSE(computes_order(unknown));
}

}  // namespace filter_kinds_test
