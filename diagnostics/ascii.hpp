// Letters, digits and blanks of ASCII, the same whatever the C locale is: other bytes belong to no class and
// have no case.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace axisc::ascii {

constexpr bool is_digit(char byte) {
  return byte >= '0' && byte <= '9';
}
constexpr bool is_capital(char byte) {
  return byte >= 'A' && byte <= 'Z';
}
constexpr bool is_small(char byte) {
  return byte >= 'a' && byte <= 'z';
}
constexpr bool is_letter(char byte) {
  return is_capital(byte) || is_small(byte);
}
/// A space or a tab.
constexpr bool is_blank(char byte) {
  return byte == ' ' || byte == '\t';
}
/// Neither a control character nor part of a longer one.
constexpr bool is_printable(char byte) {
  return byte >= ' ' && byte <= '~';
}

constexpr char lower_case(char byte) {
  return is_capital(byte) ? static_cast<char>(byte - 'A' + 'a') : byte;
}
constexpr char upper_case(char byte) {
  return is_small(byte) ? static_cast<char>(byte - 'a' + 'A') : byte;
}

inline std::string lower_case(std::string_view text) {
  std::string folded(text);
  std::transform(folded.begin(), folded.end(), folded.begin(), [](char byte) { return lower_case(byte); });
  return folded;
}
inline std::string upper_case(std::string_view text) {
  std::string folded(text);
  std::transform(folded.begin(), folded.end(), folded.begin(), [](char byte) { return upper_case(byte); });
  return folded;
}

constexpr bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower_case(x) == lower_case(y); });
}

/// True for a name that ends in `extension` (".json"), in upper or lower case, and has more before it.
constexpr bool has_extension(std::string_view name, std::string_view extension) {
  return name.size() > extension.size() &&
         equal_ignoring_case(name.substr(name.size() - extension.size()), extension);
}

/// Without the spaces and tabs at both ends.
constexpr std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// True for a zero followed by a digit, with which no decimal number of a list begins; `text` has no sign.
constexpr bool has_leading_zero(std::string_view text) {
  return text.size() > 1 && text[0] == '0' && is_digit(text[1]);
}

}  // namespace axisc::ascii
