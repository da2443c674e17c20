#include "analysis/recordings/decimal_number.hpp"

#include "support/catch.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <random>
#include <string>

namespace axisc::recordings::decimal_number_test {
namespace {

TEST_CASE("a number is the nearest double, with either mark") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    double const value = std::uniform_real_distribution<>(-1, 1)(random) *
                         std::pow(10, static_cast<double>(random() % 24) - 6);
    std::array<char, 64> text{};
    auto const digits = static_cast<int>(random() % 20);
    auto const fixed =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
    std::string written(text.data(), fixed.ptr);
    double expected = 0;
    std::from_chars(written.data(), written.data() + written.size(), expected);
    INFO(written);
    auto const point = written.find('.');
    CHECK(parse_number(written)->value == expected);
    if (point == std::string::npos) continue;
    CHECK(parse_number(written)->mark == DecimalMark::point);
    written[point] = ',';
    CHECK(parse_number(written)->value == expected);
    CHECK(parse_number(written)->mark == DecimalMark::comma);
  }
}

TEST_CASE("what is not a number") {
  for (std::string const text :
       {"", "-", "+", ".", ",", "1.2.3", "1,2.3", "1 2", "0x10", "1e", "+-1", "--1", "a"}) {
    INFO(text);
    CHECK_FALSE(parse_number(text).has_value());
  }
  CHECK(parse_number("+3")->value == 3);
  CHECK(parse_number("5.")->value == 5);
  CHECK(parse_number("-1,5E-3")->value == -0.0015);
  CHECK(parse_number("18446744073709551615")->value == 18446744073709551615.0);
  CHECK(std::signbit(parse_number("-0")->value));
  CHECK(std::isinf(parse_number("inf")->value));
  CHECK(parse_whole("0x10") == 16U);
  CHECK_FALSE(parse_whole("1.5").has_value());
}

}  // namespace
}  // namespace axisc::recordings::decimal_number_test
