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

namespace number_test {

namespace {

using axisc::grammar::real_value;

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

}  // namespace number_test
