#include "editor/text_positions.hpp"

#include "diagnostics/utf8.hpp"

#include <algorithm>

namespace axisc::editor {

namespace {

std::size_t units_of(DecodedCharacter const& character, PositionEncoding encoding) {
  if (encoding == PositionEncoding::utf8) return character.size;
  return encoding == PositionEncoding::utf16 && character.value > 0xFFFF ? 2 : 1;
}

}  // namespace

std::size_t offset_of(std::string_view text, TextPosition position, PositionEncoding encoding) {
  std::size_t at = 0;
  for (std::size_t line = 0; line < position.line; ++line) {
    at = text.find_first_of("\r\n", at);
    if (at == std::string_view::npos) return text.size();
    at += text.substr(at, 2) == "\r\n" ? 2 : 1;
  }
  auto const line = text.substr(at, text.find_first_of("\r\n", at) - at);
  return at + offset_of_unit(line, position.character, encoding);
}

std::size_t offset_of_unit(std::string_view text, std::size_t unit, PositionEncoding encoding) {
  std::size_t passed = 0;
  std::size_t at = 0;
  while (at < text.size()) {
    auto const character = decode_utf8(text.substr(at));
    passed += units_of(character, encoding);
    if (passed > unit) break;
    at += character.size;
  }
  return at;
}

TextPosition position_of(std::string_view text, std::size_t offset, PositionEncoding encoding) {
  TextPosition position;
  std::size_t begin = 0;
  for (auto end = text.find_first_of("\r\n"); end < offset; end = text.find_first_of("\r\n", begin)) {
    auto const next = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
    if (next > offset) break;
    begin = next;
    ++position.line;
  }
  auto const line = text.substr(begin, std::min(offset, text.size()) - begin);
  position.character = units(line, line.size(), encoding);
  return position;
}

std::size_t units(std::string_view line, std::size_t characters, PositionEncoding encoding) {
  std::size_t sum = 0;
  for (; characters > 0 && !line.empty(); --characters) {
    auto const character = decode_utf8(line);
    sum += units_of(character, encoding);
    line.remove_prefix(character.size);
  }
  return sum;
}

}  // namespace axisc::editor
