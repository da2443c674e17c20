#include "grammar/number.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <string_view>

namespace {

using axisc::grammar::integer_value;
using axisc::grammar::IntegerValue;
using axisc::grammar::real_value;

constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();

TEST_CASE("integers keep sign and magnitude") {
  CHECK(integer_value("0") == IntegerValue{false, 0});
  CHECK(integer_value("-0") == IntegerValue{false, 0});
  CHECK(integer_value("20") == IntegerValue{false, 20});
  CHECK(integer_value("+20") == IntegerValue{false, 20});
  CHECK(integer_value("-20") == IntegerValue{true, 20});
  CHECK(integer_value("0x1F") == IntegerValue{false, 31});
  CHECK(integer_value("0Xff") == IntegerValue{false, 255});
  CHECK(integer_value("18446744073709551615") == IntegerValue{false, largest});
  CHECK(integer_value("-18446744073709551615") == IntegerValue{true, largest});
  CHECK(integer_value("0xFFFFFFFFFFFFFFFF") == IntegerValue{false, largest});
}

TEST_CASE("a magnitude above 2^64 - 1 is no integer value") {
  CHECK_FALSE(integer_value("18446744073709551616"));
  CHECK_FALSE(integer_value("-18446744073709551616"));
  CHECK_FALSE(integer_value("0x10000000000000000"));
  CHECK_FALSE(integer_value(std::string(1000, '9')));
}

TEST_CASE("what is no integer token has no integer value") {
  for (std::string_view const token :
       {"", "+", "-", "0x", "1.5", "1e5", "abc", "0x1G", "--1", "+-1", " 1", "1 "}) {
    INFO(token);
    CHECK_FALSE(integer_value(token));
  }
}

TEST_CASE("reals are the nearest double") {
  CHECK(real_value("1.8") == 1.8);
  CHECK(real_value("+1.8") == 1.8);
  CHECK(real_value("-1.8") == -1.8);
  CHECK(real_value(".5") == 0.5);
  CHECK(real_value("1.") == 1.0);
  CHECK(real_value("20") == 20.0);
  CHECK(real_value("3.000000e+001") == 30.0);
  CHECK(real_value("1.e5") == 1e5);
  CHECK(real_value("1E-3") == 1e-3);
  CHECK(real_value("9007199254740993") == 9007199254740992.0);  // half-way, to even
  CHECK(real_value("9007199254740993.000000000000000000000000001") == 9007199254740994.0);
  CHECK(real_value("0.1000000000000000055511151231257827") == 0.1);
  CHECK(real_value("1.7976931348623157e308") == std::numeric_limits<double>::max());
  CHECK(real_value("5e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(std::signbit(real_value("-0.0").value()));
}

TEST_CASE("doubles survive being written and read") {
  std::mt19937_64 random(1);
  for (int round = 0; round < 20000; ++round) {
    double value = 0;
    std::uint64_t const bits = random();
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    char text[64];
    std::snprintf(text, sizeof text, "%.17e", value);
    INFO(text);
    REQUIRE(real_value(text) == value);
  }
}

TEST_CASE("a real beyond the largest double has no value, one below the smallest is 0") {
  CHECK_FALSE(real_value("1e309"));
  CHECK_FALSE(real_value("-1e309"));
  CHECK_FALSE(real_value("1.7976931348623159e308"));
  CHECK_FALSE(real_value("1e99999999999999999999"));
  CHECK_FALSE(real_value("0.0001e400"));
  CHECK_FALSE(real_value(std::string(400, '9')));
  CHECK(real_value("1e-400") == 0.0);
  CHECK(real_value("1e-99999999999999999999") == 0.0);
  CHECK(real_value("1000.5e-400") == 0.0);
  CHECK(real_value("0e99999999999999999999") == 0.0);
  CHECK(real_value("0.000e400") == 0.0);
  CHECK(std::signbit(real_value("-1e-400").value()));
  CHECK(real_value("0." + std::string(400, '0') + "1e402") == 10.0);
  CHECK(real_value("0." + std::string(400, '0') + "1") == 0.0);
}

TEST_CASE("what is no number token has no real value") {
  for (std::string_view const token :
       {"", "+", ".", "-.", "e5", "inf", "nan", "-inf", "1,8", "0x1F", "1e", "1.5x", "--1"}) {
    INFO(token);
    CHECK_FALSE(real_value(token));
  }
}

}  // namespace
