#include "diagnostics/format_number.hpp"

#include "support/catch.hpp"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

using namespace axisc;

TEST_CASE("exact numbers are the shortest text that reads back") {
  CHECK(format_exact(0.1) == "0.1");
  CHECK(format_exact(100000.0) == "100000");
  CHECK(format_exact(-1.5) == "-1.5");
  CHECK(format_exact(0.0) == "0");
  CHECK(format_exact(-0.0) == "-0");
  CHECK(format_exact(1e9 + 0.125) == "1000000000.125");
  CHECK(format_exact(0.00001) == "0.00001");
  CHECK(format_exact(1e-7) == "1e-07");
  CHECK(format_exact(1e300) == "1e+300");
  CHECK(format_exact(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(format_exact(-std::numeric_limits<double>::infinity()) == "-inf");
  CHECK(format_exact(std::numeric_limits<double>::quiet_NaN()) == "nan");
}

TEST_CASE("any double reads back exactly") {
  std::mt19937_64 random(20240117);
  for (int round = 0; round < 20000; ++round) {
    std::uint64_t const bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (round % 2 == 0) value = static_cast<double>(static_cast<std::int64_t>(bits)) / 4096.0 / 1048576.0;
    if (!std::isfinite(value)) continue;
    std::string const text = format_exact(value);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    if (std::memcmp(&read, &value, sizeof value) != 0) FAIL(text);
  }
}

TEST_CASE("rounded numbers have no more digits than asked for") {
  CHECK(format_rounded(6.283185307179586, 3) == "6.28");
  CHECK(format_rounded(0.0012345, 3) == "0.00123");
  CHECK(format_rounded(2.0, 4) == "2");
  CHECK(format_rounded(2.50, 4) == "2.5");
  CHECK(format_rounded(12000.0, 3) == "12000");
  CHECK(format_rounded(1234.6, 3) == "1235");
  CHECK(format_rounded(9.996, 3) == "10");
  CHECK(format_rounded(99.96, 3) == "100");
  CHECK(format_rounded(0.9996, 3) == "1");
  CHECK(format_rounded(-0.0, 3) == "0");
  CHECK(format_rounded(0.0, 1) == "0");
  CHECK(format_rounded(-12.345, 4) == "-12.35");
  CHECK(format_rounded(1.0 / 3.0, 17) == "0.33333333333333331");
}

TEST_CASE("very large and very small numbers are rounded with an exponent") {
  CHECK(format_rounded(1.2345e-7, 2) == "1.2e-07");
  CHECK(format_rounded(1e-7, 4) == "1e-07");
  CHECK(format_rounded(1.5e20, 3) == "1.5e+20");
  CHECK(format_rounded(std::numeric_limits<double>::infinity(), 3) == "inf");
}

TEST_CASE("a number of digits out of range is limited") {
  CHECK(format_rounded(1.25, 0) == "1");
  CHECK(format_rounded(0.5, 400) == "0.5");
}
