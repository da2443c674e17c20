#include "editor/meaning/parameter_number.hpp"

#include "diagnostics/ascii.hpp"

#include <charconv>

namespace axisc::editor {

namespace {

bool continues_number(char character) {
  return ascii::is_letter(character) || ascii::is_digit(character) || character == '-';
}

}  // namespace

std::optional<ParameterNumber> parameter_number_at(std::string_view text, std::size_t offset) {
  auto begin = offset;
  while (begin > 0 && continues_number(text[begin - 1])) --begin;
  auto end = offset;
  while (end < text.size() && continues_number(text[end])) ++end;
  auto const word = text.substr(begin, end - begin);
  auto const hyphen = word.rfind('-');
  if (!word.starts_with("P-") || hyphen < 2) return std::nullopt;
  auto const kind = schema::find_list_kind(&schema::ListKindRow::family, word.substr(2, hyphen - 2));
  ParameterNumber found{.kind = {}, .number = 0, .begin = begin, .end = end};
  auto const* const last = word.data() + word.size();
  auto const [stop, error] = std::from_chars(word.data() + hyphen + 1, last, found.number);
  if (!kind || error != std::errc() || stop != last) return std::nullopt;
  found.kind = *kind;
  return found;
}

}  // namespace axisc::editor
