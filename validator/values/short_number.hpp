// Decimal numbers of a few digits, as nearly all numbers of a list are, eight digits at a time.
//
// The number of digits differs from line to line, so the end of a loop over them is mispredicted. Numbers
// that are read here read the same in schema/value.hpp, which reads everything else too. The texts may be any
// tokens; the caller must reject leading zeros, which no number may have.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace axisc::validator {

namespace digits {

/// The eight bytes before `end`, the first one lowest.
inline std::uint64_t eight_bytes_before(char const* end) {
  std::uint64_t word = 0;
  std::memcpy(&word, end - sizeof word, sizeof word);
  if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
  return word;
}

constexpr std::uint64_t eight_times(unsigned char byte) {
  return 0x0101010101010101U * byte;
}

/// The number that the last `count` bytes (1 to 8) before `end` form as digits; `wrong` becomes non-zero if
/// one is not a digit.
inline std::uint64_t digits_before(char const* end, std::size_t count, std::uint64_t& wrong) {
  std::size_t const others = 64 - 8 * count;
  std::uint64_t const values = ((eight_bytes_before(end) ^ eight_times('0')) >> others) << others;
  wrong |= (values | (values + eight_times(0x80 - 10))) & eight_times(0x80);
  // Pairs of digits, then four and eight of them: D. Lemire, "Quickly parsing eight digits", 2018.
  std::uint64_t const pairs = values * 10 + (values >> 8U);
  constexpr std::uint64_t every_fourth = 0x000000FF000000FF;
  constexpr std::uint64_t high = 100 + (std::uint64_t{1000000} << 32U);
  constexpr std::uint64_t low = 1 + (std::uint64_t{10000} << 32U);
  return ((pairs & every_fourth) * high + ((pairs >> 16U) & every_fourth) * low) >> 32U;
}

/// Number of bytes between the last point and `end`, within the last eight bytes; 8 if there is no point.
inline std::size_t bytes_behind_point(char const* end) {
  std::uint64_t const others = eight_bytes_before(end) ^ eight_times('.');
  constexpr std::uint64_t low_bits = eight_times(0x7F);
  std::uint64_t const points = ~(((others & low_bits) + low_bits) | others | low_bits);
  return static_cast<std::size_t>(std::countl_zero(points)) / 8;
}

inline bool is_sign(char byte) {
  return byte == '+' || byte == '-';
}

inline constexpr std::size_t most_digits = 8;

/// Powers of ten that a double holds exactly.
inline constexpr std::array<double, 23> powers_of_ten = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
inline constexpr std::array<std::uint64_t, 8> whole_powers_of_ten = {1,     10,     100,     1000,
                                                                     10000, 100000, 1000000, 10000000};

}  // namespace digits

/// Number of bytes that must be readable before the end of a number, its own included.
inline constexpr std::size_t room_before_number_end = 24;

/// The decimal integer in [begin, end): a sign or none, one to eight digits. False for every other text. (An
/// optional travels through memory, written in two parts and read as one, which a processor has to wait for.)
inline bool read_short_integer(char const* begin, char const* end, double& number) {
  bool const is_negative = *begin == '-';
  char const* const first = begin + (digits::is_sign(*begin) ? 1 : 0);
  auto const count = static_cast<std::size_t>(end - first);
  if (count - 1 >= digits::most_digits) return false;
  std::uint64_t wrong = 0;
  auto const value = static_cast<double>(digits::digits_before(end, count, wrong));
  number = is_negative ? -value : value;
  return wrong == 0;
}

/// The real in [begin, end): a sign or none, one to eight digits, a point, one to seven digits, an exponent
/// like `e+03` or `e+003`, or none. False for every other text. The digits and the power of ten are exact as
/// doubles, so one multiplication or division rounds as it should (W. D. Clinger, "How to read floating point
/// numbers accurately", 1990).
inline bool read_short_real(char const* begin, char const* end, double& number) {
  bool const is_negative = *begin == '-';
  char const* const first = begin + (digits::is_sign(*begin) ? 1 : 0);
  std::uint64_t wrong = 0;
  std::int64_t exponent = 0;
  std::ptrdiff_t const exponent_digits = (end[-5] | 0x20) == 'e' ? 3 : 2;
  char const* const sign = end - exponent_digits - 1;
  if ((sign[-1] | 0x20) == 'e' && sign > first && digits::is_sign(*sign)) {
    exponent = static_cast<std::int64_t>(
        digits::digits_before(end, static_cast<std::size_t>(exponent_digits), wrong));
    if (*sign == '-') exponent = -exponent;
    end = sign - 1;
  }
  std::size_t const behind = digits::bytes_behind_point(end);
  // A point before the number, or none, makes this wrap around.
  std::size_t const before = static_cast<std::size_t>(end - first) - behind - 1;
  if (behind - 1 >= digits::most_digits - 1 || before - 1 >= digits::most_digits) {
    return false;
  }
  std::uint64_t const whole = digits::digits_before(end - behind - 1, before, wrong);
  std::uint64_t const fraction = digits::digits_before(end, behind, wrong);
  exponent -= static_cast<std::int64_t>(behind);
  auto const size = static_cast<std::size_t>(exponent < 0 ? -exponent : exponent);
  if (wrong != 0 || size >= digits::powers_of_ten.size()) return false;
  auto const all_digits = static_cast<double>(whole * digits::whole_powers_of_ten[behind] + fraction);
  double const power = digits::powers_of_ten[size];
  double const value = exponent < 0 ? all_digits / power : all_digits * power;
  number = is_negative ? -value : value;
  return true;
}

}  // namespace axisc::validator
