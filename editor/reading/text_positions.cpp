#include "editor/reading/text_positions.hpp"

#include "diagnostics/utf8.hpp"

#include <algorithm>

namespace axisc::editor {

namespace {

std::size_t units_of(DecodedCharacter const& character, PositionEncoding encoding) {
  if (encoding == PositionEncoding::utf8) return character.size;
  return encoding == PositionEncoding::utf16 && character.value > 0xFFFF ? 2 : 1;
}

}  // namespace

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

std::size_t units(std::string_view line, std::size_t characters, PositionEncoding encoding) {
  std::size_t sum = 0;
  for (; characters > 0 && !line.empty(); --characters) {
    auto const character = decode_utf8(line);
    sum += units_of(character, encoding);
    line.remove_prefix(character.size);
  }
  return sum;
}

TextLines::TextLines(std::string_view text, PositionEncoding encoding) : text_(text), encoding_(encoding) {
  begins_.push_back(0);
  for (auto end = text.find_first_of("\r\n"); end != std::string_view::npos;
       end = text.find_first_of("\r\n", begins_.back())) {
    begins_.push_back(end + (text.substr(end, 2) == "\r\n" ? 2 : 1));
  }
}

std::string_view TextLines::line(std::size_t line) const {
  auto const rest = text_.substr(begins_[line]);
  return rest.substr(0, rest.find_first_of("\r\n"));
}

std::size_t TextLines::offset(TextPosition position) const {
  if (position.line >= count()) return text_.size();
  return begin(position.line) + offset_of_unit(line(position.line), position.character, encoding_);
}

TextPosition TextLines::position(std::size_t offset) const {
  auto const after = std::upper_bound(begins_.begin(), begins_.end(), offset);
  auto const line = static_cast<std::size_t>(after - begins_.begin()) - 1;
  return {.line = line, .character = units_of(text_.substr(begins_[line], offset - begins_[line]))};
}

}  // namespace axisc::editor
