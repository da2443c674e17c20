#include "diagnostics/windows_1252.hpp"

#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <array>

namespace axisc {
namespace {

// Bytes 0x80 to 0x9F; all others have the number of their character.
constexpr std::array<char32_t, 32> upper_controls{
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,  // 80
    0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD,  // 88
    0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,  // 90
    0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178,  // 98
};

}  // namespace

char32_t decode_windows_1252(char byte) {
  auto const number = static_cast<unsigned char>(byte);
  return number >= 0x80 && number < 0xA0 ? upper_controls.at(number - 0x80U) : char32_t{number};
}

std::optional<char> encode_windows_1252(char32_t character) {
  if (character < 0x80 || (character >= 0xA0 && character <= 0xFF)) return static_cast<char>(character);
  if (character == replacement_character) return std::nullopt;
  auto const* const found = std::find(upper_controls.begin(), upper_controls.end(), character);
  if (found == upper_controls.end()) return std::nullopt;
  return static_cast<char>(0x80 + (found - upper_controls.begin()));
}

}  // namespace axisc
