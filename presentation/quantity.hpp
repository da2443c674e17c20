// A number with its unit: the one home of digits, decimal signs and units. A value is kept as it was
// computed; the digits that a reader sees are chosen when it is written.
#pragma once

#include "diagnostics/sentence.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace axisc::presentation {

enum class Unit : std::uint8_t {
  none,
  cycle,
  microsecond,
  millisecond,
  second,
  hertz,
  decibel,
  degree,
  radian,
  percent,
  share,  ///< people see percent: "20 %" of 0.2
  micrometre,
  millimetre,
  millimetre_per_second,
  micrometre_per_second,
  millimetre_per_minute,
  degree_per_second,
  millimetre_per_second_squared,
  metre_per_second_squared,
  degree_per_second_squared,
  byte,
};

/// How many digits a reader sees. Programs always get the number that reads back as the same double.
struct Digits {
  enum class Kind : std::uint8_t {
    exact,        ///< the shortest text that reads back as the same double
    significant,  ///< see format_rounded()
    decimals,     ///< as many after the decimal sign, zeros included
  };
  Kind kind = Kind::significant;
  int count = 4;

  [[nodiscard]] static constexpr Digits exact() { return {.kind = Kind::exact, .count = 0}; }
  [[nodiscard]] static constexpr Digits significant(int count) {
    return {.kind = Kind::significant, .count = count};
  }
  [[nodiscard]] static constexpr Digits decimals(int count) {
    return {.kind = Kind::decimals, .count = count};
  }
};

struct Quantity {
  double value = 0;
  Unit unit = Unit::none;
  Digits digits = {};
};

/// A value that people see with all its digits.
[[nodiscard]] constexpr Quantity exact(double value, Unit unit = Unit::none) {
  return {.value = value, .unit = unit, .digits = Digits::exact()};
}
[[nodiscard]] constexpr Quantity rounded(double value, Unit unit, int digits) {
  return {.value = value, .unit = unit, .digits = Digits::significant(digits)};
}
[[nodiscard]] constexpr Quantity fixed(double value, Unit unit, int decimals) {
  return {.value = value, .unit = unit, .digits = Digits::decimals(decimals)};
}

/// "13.8", in German "13,8"; "-" where there is no number, "∞" and "-∞" beyond all numbers.
[[nodiscard]] std::string number_text(Quantity const& quantity, Language language);
/// "13.8 ms", "5°", "20 %".
[[nodiscard]] std::string quantity_text(Quantity const& quantity, Language language);
/// "ms", as headings of columns have it; empty for numbers without a unit.
[[nodiscard]] std::string_view symbol(Unit unit, Language language);

/// For programs: reads back as the same double; "null" where there is no finite number.
[[nodiscard]] std::string json_number(double value);

}  // namespace axisc::presentation
