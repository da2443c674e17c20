#include "image/fmu/compact_source.hpp"

namespace axisc::image {

namespace {

/// Where the literal ends that begins here.
std::size_t end_of_literal(std::string_view source, std::size_t begin) {
  auto end = begin + 1;
  while (source[end] != source[begin]) end += source[end] == '\\' ? 2U : 1U;
  return end + 1;
}

/// Leaves neither blanks at the end of a line nor a line, or two empty ones, where a comment was.
std::size_t close_gap(std::string& text, std::string_view source, std::size_t at) {
  text.erase(text.find_last_not_of(' ') + 1);
  if (source[at] != '\n') {
    text += ' ';
  } else if (text.ends_with('\n')) {
    at += 1;
    if (text.ends_with("\n\n") && source[at] == '\n') at += 1;
  }
  return at;
}

}  // namespace

std::string compact_source(std::string_view source) {
  auto at = source.starts_with("/*") ? source.find("*/") + 2 : 0;
  std::string text(source.substr(0, at));
  while (at < source.size()) {
    if (source.substr(at).starts_with("/*")) {
      at = close_gap(text, source, source.find("*/", at) + 2);
      continue;
    }
    bool const is_literal = source[at] == '"' || source[at] == '\'';
    auto const end = is_literal ? end_of_literal(source, at) : at + 1;
    text += source.substr(at, end - at);
    at = end;
  }
  return text;
}

}  // namespace axisc::image
