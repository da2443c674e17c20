#include "cli/report/json_text.hpp"

#include "diagnostics/format_number.hpp"
#include "diagnostics/utf8.hpp"

#include <cmath>

namespace axisc::cli {

std::string json_string(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result = "\"";
  for (char const character : repair_utf8(text)) {
    auto const byte = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      result += '\\';
      result += character;
    } else if (byte < 0x20U) {
      result += "\\u00";
      result += digits[byte >> 4U];
      result += digits[byte & 0xFU];
    } else {
      result += character;
    }
  }
  return result + '"';
}

std::string json_number(double value) {
  return std::isfinite(value) ? format_exact(value) : "null";
}

}  // namespace axisc::cli
