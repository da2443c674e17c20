#include "editor/text_positions.hpp"

#include "diagnostics/utf8.hpp"

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
  std::size_t passed = 0;
  while (at < text.size() && text[at] != '\r' && text[at] != '\n') {
    auto const character = decode_utf8(text.substr(at));
    passed += units_of(character, encoding);
    if (passed > position.character) break;
    at += character.size;
  }
  return at;
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
