#include "diagnostics/terminal.hpp"

#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>

namespace axisc {
namespace {

struct Range {
  char32_t first;
  char32_t last;
};

/// Control characters, separators of lines, and characters without width or that turn the direction of
/// writing.
constexpr Range invisible[] = {{0x00, 0x1F},     {0x7F, 0x9F},     {0xAD, 0xAD},      {0x61C, 0x61C},
                               {0x180E, 0x180E}, {0x200B, 0x200F}, {0x2028, 0x202E},  {0x2060, 0x206F},
                               {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB}, {0xE0000, 0xE007F}};

bool are_eight_plain(char const* text) {
  constexpr std::uint64_t ones = 0x0101010101010101U;
  constexpr std::uint64_t top_bits = 0x80U * ones;
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, text, sizeof bytes);
  // A byte below 0x20 borrows from its top bit, 0x7F carries into it; it does not matter which byte it was.
  return ((bytes | (bytes - 0x20U * ones) | (bytes + ones)) & top_bits) == 0;
}

std::string_view escape_of(Style style) {
  switch (style) {
    case Style::error: return "\x1b[1;31m";
    case Style::warning: return "\x1b[1;33m";
    case Style::note: return "\x1b[1;36m";
    case Style::gutter: return "\x1b[1;34m";
    case Style::added: return "\x1b[32m";
    case Style::removed: return "\x1b[31m";
    case Style::strong: break;
  }
  return "\x1b[1m";
}

}  // namespace

bool is_visible(char32_t character) {
  return std::none_of(std::begin(invisible), std::end(invisible), [character](Range const& range) {
    return character >= range.first && character <= range.last;
  });
}

bool is_visible(std::string_view text) {
  if (is_plain(text)) return true;
  while (!text.empty()) {
    DecodedCharacter const character = decode_utf8(text);
    if (!is_visible(character.value)) return false;
    text.remove_prefix(character.size);
  }
  return true;
}

void append_printable(std::string& shown, char32_t character) {
  constexpr char32_t picture_of_null = 0x2400;
  constexpr char32_t picture_of_delete = 0x2421;
  if (character < 0x20) {
    append_utf8(shown, picture_of_null + character);
  } else if (character == 0x7F) {
    append_utf8(shown, picture_of_delete);
  } else {
    append_utf8(shown, is_visible(character) ? character : replacement_character);
  }
}

void append_printable(std::string& shown, std::string_view text) {
  if (is_plain(text)) {
    shown += text;
    return;
  }
  while (!text.empty()) {
    auto const* const special =
        std::find_if_not(text.begin(), text.end(), [](char byte) { return is_plain(byte); });
    auto const plain = static_cast<std::size_t>(special - text.begin());
    shown.append(text.substr(0, plain));
    text.remove_prefix(plain);
    if (text.empty()) return;
    DecodedCharacter const character = decode_utf8(text);
    append_printable(shown, character.value);
    text.remove_prefix(character.size);
  }
}

bool is_plain(std::string_view text) {
  constexpr std::size_t step = sizeof(std::uint64_t);
  if (text.size() < step) {
    return std::all_of(text.begin(), text.end(), [](char byte) { return is_plain(byte); });
  }
  for (std::size_t at = 0; at + step < text.size(); at += step) {
    if (!are_eight_plain(text.data() + at)) return false;
  }
  return are_eight_plain(text.data() + text.size() - step);
}

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  append_printable(shown, text);
  return shown;
}

std::string Painter::operator()(Style style, std::string_view text) const {
  std::string painted;
  append(painted, style, text);
  return painted;
}

void Painter::begin_color(std::string& out, Style style) {
  out += escape_of(style);
}

void Painter::end_color(std::string& out) {
  out += "\x1b[0m";
}

}  // namespace axisc
