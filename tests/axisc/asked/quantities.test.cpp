#include "axisc/asked/quantities.hpp"

#include "support/catch.hpp"

#include <string>

using namespace axisc;

namespace {

std::uint32_t nanoseconds(std::string const& text) {
  auto const time = parse_cycle_time(text);
  return time ? time->nanoseconds : 0;
}

}  // namespace

TEST_CASE("cycle times in every unit") {
  CHECK(nanoseconds("1ms") == 1'000'000);
  CHECK(nanoseconds("250us") == 250'000);
  CHECK(nanoseconds("250\u00B5s") == 250'000);
  CHECK(nanoseconds("250\u03BCs") == 250'000);
  CHECK(nanoseconds("0.5ms") == 500'000);
  CHECK(nanoseconds("1000") == 1'000'000);
  CHECK(nanoseconds("62.5") == 62'500);
  CHECK(nanoseconds("125000ns") == 125'000);
  CHECK(nanoseconds("0.001s") == 1'000'000);
  CHECK(nanoseconds("1s") == 1'000'000'000);
  CHECK(nanoseconds("1 ms") == 1'000'000);
  CHECK(nanoseconds("1e3") == 1'000'000);
  CHECK(nanoseconds("0.3ms") == 300'000);
}

TEST_CASE("what is no cycle time") {
  for (auto const* const text : {"", "ms", "0", "-1ms", "1,5ms", "1h", "2s", "1.0000001s", "0.3333us", "nan",
                                 "inf", "1ms2", "0x10", "1 000", "1e99"}) {
    INFO(text);
    CHECK_FALSE(parse_cycle_time(text));
  }
}

TEST_CASE("numbers are read whole or not at all") {
  CHECK(parse_number("+1.5") == 1.5);
  CHECK(parse_number("0.1") == 0.1);
  CHECK_FALSE(parse_number("1.5 "));
  CHECK_FALSE(parse_number("++1"));
  CHECK_FALSE(parse_number("1,5"));
  CHECK_FALSE(parse_number(""));
  CHECK_FALSE(parse_finite("inf"));
  CHECK_FALSE(parse_finite("nan"));
  CHECK(parse_count("18446744073709551615") == 18446744073709551615U);
  CHECK_FALSE(parse_count("18446744073709551616"));
  CHECK_FALSE(parse_count("-1"));
  CHECK_FALSE(parse_count("1.0"));
}
