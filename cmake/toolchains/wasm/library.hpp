// The parts of C++20 that the C++ library of Debian's emscripten (LLVM 13) lacks and this project uses.
// Included before every source of that build, and of no other.
#pragma once

#if defined(__cplusplus) && __cplusplus >= 202002L

#include <cerrno>
#include <charconv>
#include <compare>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <version>

namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> &&
         is_trivially_copyable_v<From>) constexpr To bit_cast(From const& value) noexcept {
  return __builtin_bit_cast(To, value);
}
#endif

#ifndef __cpp_lib_smart_ptr_for_overwrite
template <class T>
unique_ptr<T> make_unique_for_overwrite(size_t count) {
  return unique_ptr<T>(new remove_extent_t<T>[count]);
}
#endif

#ifndef __cpp_lib_three_way_comparison
template <class Char, class Traits, class Allocator>
constexpr strong_ordering operator<=>(basic_string<Char, Traits, Allocator> const& a,
                                      basic_string<Char, Traits, Allocator> const& b) noexcept {
  return a.compare(b) <=> 0;
}

template <class Char, class Traits>
constexpr strong_ordering operator<=>(basic_string_view<Char, Traits> a,
                                      basic_string_view<Char, Traits> b) noexcept {
  return a.compare(b) <=> 0;
}

template <class T>
constexpr strong_ordering operator<=>(optional<T> const& a, optional<T> const& b) {
  return a && b ? *a <=> *b : a.has_value() <=> b.has_value();
}
#endif

/// strtod of musl rounds correctly; what it takes beyond from_chars is refused.
inline from_chars_result from_chars(char const* first, char const* last, double& value,
                                    chars_format = chars_format::general) {
  string const text(first, last);
  char const* at = text.c_str();
  if (*at == '-') ++at;
  bool const is_decimal = (*at >= '0' && *at <= '9') || *at == '.';
  bool const is_word = *at == 'i' || *at == 'I' || *at == 'n' || *at == 'N';
  bool const is_hexadecimal = *at == '0' && (at[1] == 'x' || at[1] == 'X');
  if (is_hexadecimal) {
    value = text.front() == '-' ? -0.0 : 0.0;
    return {first + (at - text.c_str()) + 1, errc()};
  }
  if (!is_decimal && !is_word) return {first, errc::invalid_argument};
  char* end = nullptr;
  errno = 0;
  double const read = strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, errc::invalid_argument};
  from_chars_result const result{first + (end - text.c_str()), errc()};
  bool const overflows = read == __builtin_huge_val() || read == -__builtin_huge_val();
  if (errno == ERANGE && (overflows || read == 0)) return {result.ptr, errc::result_out_of_range};
  value = read;
  return result;
}

inline to_chars_result print_double(char* first, char* last, char const* format, int precision,
                                    double value) {
  char text[1100];
  int const length = snprintf(text, sizeof text, format, precision, value);
  if (length < 0 || length > last - first) return {last, errc::value_too_large};
  memcpy(first, text, static_cast<size_t>(length));
  return {first + length, errc()};
}

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision) {
  return print_double(first, last, format == chars_format::fixed ? "%.*f" : "%.*e", precision, value);
}

/// The fewest digits that read as the same number.
inline int shortest_digits(double value) {
  char text[40];
  for (int digits = 0; digits < 16; ++digits) {
    snprintf(text, sizeof text, "%.*e", digits, value);
    if (strtod(text, nullptr) == value) return digits;
  }
  return 16;
}

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format) {
  int const digits = shortest_digits(value);
  if (format == chars_format::scientific) return to_chars(first, last, value, format, digits);
  char text[40];
  snprintf(text, sizeof text, "%.*e", digits, value);
  int const exponent = atoi(strchr(text, 'e') + 1);
  return to_chars(first, last, value, chars_format::fixed, digits > exponent ? digits - exponent : 0);
}

inline to_chars_result to_chars(char* first, char* last, double value) {
  if (value != value || value == __builtin_huge_val() || value == -__builtin_huge_val()) {
    return print_double(first, last, "%.*f", 0, value);
  }
  char a[1100];
  char b[1100];
  auto const plain = to_chars(a, a + sizeof a, value, chars_format::fixed);
  auto const scientific = to_chars(b, b + sizeof b, value, chars_format::scientific);
  bool const is_plain = plain.ptr - a <= scientific.ptr - b;
  auto const length = is_plain ? plain.ptr - a : scientific.ptr - b;
  if (length > last - first) return {last, errc::value_too_large};
  memcpy(first, is_plain ? a : b, static_cast<size_t>(length));
  return {first + length, errc()};
}

}  // namespace std

#endif
