#include "presentation/pictures/text_width.hpp"

#include <cstddef>

namespace axisc::pictures {
namespace {

/// In em, of DejaVu Sans, the widest of the usual ones.
double letter_width(char letter) {
  constexpr std::string_view narrow = "iljI.,:;|!'()[]/ ft";
  constexpr std::string_view wide = "mwMW@%";
  if (narrow.find(letter) != std::string_view::npos) return 0.4;
  if (wide.find(letter) != std::string_view::npos) return 0.98;
  bool const is_capital = letter >= 'A' && letter <= 'Z';
  return is_capital ? 0.74 : 0.64;
}

}  // namespace

double text_width(std::string_view text, double size) {
  double width = 0;
  for (char const byte : text) {
    // The first byte of a character that is not ASCII counts.
    auto const value = static_cast<unsigned char>(byte);
    bool const continues = (value & 0xC0U) == 0x80U;
    if (!continues) width += value < 0x80U ? letter_width(byte) : 0.74;
  }
  return width * size;
}

std::string fitted(std::string_view text, double size, double width) {
  if (text_width(text, size) <= width) return std::string(text);
  constexpr std::string_view ellipsis = "…";
  double const room = width - text_width(ellipsis, size);
  auto const continues = [&](std::size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
  };
  std::size_t end = text.size();
  while (end > 0 && (text_width(text.substr(0, end), size) > room || continues(end))) --end;
  return std::string(text.substr(0, end)).append(ellipsis);
}

}  // namespace axisc::pictures
