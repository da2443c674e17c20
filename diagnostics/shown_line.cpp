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

/// The characters of a line that stand in the window, and the indent of the mark.
void append_window(ShownLine& shown, std::string_view line, Window window, std::size_t mark) {
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
}

/// The same for a line of which every byte is a character that stays as it is.
void append_plain_window(ShownLine& shown, std::string_view line, Window window, std::size_t mark) {
  shown.text += line.substr(window.begin, window.end - window.begin);
  std::string_view const before = line.substr(window.begin, mark - window.begin);
  shown.indent.append(before.size(), ' ');
  for (std::size_t tab = before.find('\t'); tab != std::string_view::npos; tab = before.find('\t', tab + 1)) {
    shown.indent[shown.indent.size() - before.size() + tab] = '\t';
  }
}

}  // namespace

ShownLine show_line(std::string_view line, MarkedPart marked) {
  bool const plain = is_plain(line) ||
                     std::all_of(line.begin(), line.end(), [](char c) { return is_plain(c) || c == '\t'; });
  std::size_t const length = plain ? line.size() : count_characters(line);
  std::size_t const mark = std::min(marked.begin, length);
  Window const window = window_around({.begin = mark, .end = marked.end}, length);

  ShownLine shown;
  if (window.begin > 0) {
    shown.text += ellipsis;
    shown.indent += ' ';
  }
  if (plain) {
    append_plain_window(shown, line, window, mark);
  } else {
    append_window(shown, line, window, mark);
  }
  if (window.end < length) shown.text += ellipsis;

  std::size_t const end = std::min(marked.end, window.end);
  shown.width = end > mark ? end - mark : 1;
  return shown;
}

}  // namespace axisc
