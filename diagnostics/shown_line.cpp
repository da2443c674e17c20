#include "diagnostics/shown_line.hpp"

#include "diagnostics/terminal.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace axisc {
namespace {

constexpr std::string_view ellipsis = "…";

struct Window {
  std::size_t begin;
  std::size_t end;
};

// A third of the window stands before the marked part: names stand left of values.
Window window_around(MarkedPart marked, std::size_t length) {
  if (length <= longest_shown_line) return {0, length};
  constexpr std::size_t before = longest_shown_line / 3;
  std::size_t const wanted = marked.begin - std::min(marked.begin, before);
  std::size_t const begin = std::min(wanted, length - longest_shown_line);
  return {begin, begin + longest_shown_line};
}

std::size_t count_characters(std::string_view line) {
  std::size_t count = 0;
  for (; !line.empty(); ++count) line.remove_prefix(decode_utf8(line).size);
  return count;
}

}  // namespace

ShownLine show_line(std::string_view line, MarkedPart marked) {
  std::size_t const length = count_characters(line);
  std::size_t const mark = std::min(marked.begin, length);
  Window const window = window_around({.begin = mark, .end = marked.end}, length);

  ShownLine shown;
  if (window.begin > 0) {
    shown.text += ellipsis;
    shown.indent += ' ';
  }
  for (std::size_t at = 0; at < window.end; ++at) {
    DecodedCharacter const character = decode_utf8(line);
    line.remove_prefix(character.size);
    if (at < window.begin) continue;
    bool const is_tab = character.value == U'\t';
    if (is_tab) {
      shown.text += '\t';
    } else {
      append_printable(shown.text, character.value);
    }
    if (at < mark) shown.indent += is_tab ? '\t' : ' ';
  }
  if (window.end < length) shown.text += ellipsis;

  std::size_t const end = std::min(marked.end, window.end);
  shown.width = end > mark ? end - mark : 1;
  return shown;
}

}  // namespace axisc
