#include "diagnostics/writers/shown_line.hpp"

#include "diagnostics/terminal.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace axisc {
namespace {

constexpr std::string_view ellipsis = "…";

bool stays_as_it_is(std::string_view line) {
  return is_plain(line) ||
         std::all_of(line.begin(), line.end(), [](char c) { return is_plain(c) || c == '\t'; });
}

std::size_t count_characters(std::string_view line) {
  std::size_t count = 0;
  for (; !line.empty(); ++count) line.remove_prefix(decode_utf8(line).size);
  return count;
}

struct ShownPart {
  std::size_t begin = 0, end = 0;
};

/// The beginning of the line, which contains the name, if the whole marked part is in it; otherwise a third
/// of the window is before the marked part. A sign takes one place at each end that is cut.
ShownPart window_around(std::size_t mark, std::size_t mark_end, std::size_t length, std::size_t room) {
  if (length <= room) return {.begin = 0, .end = length};
  if (std::min(mark_end, length) < room) return {.begin = 0, .end = room - 1};
  std::size_t const marked = std::min(mark_end, length) - mark;
  std::size_t const inside = room - 2;
  std::size_t const before = std::min(inside / 3, inside - std::min(inside, marked));
  std::size_t const begin = mark - std::min(mark, before);
  if (begin + room - 1 >= length) return {.begin = length - (room - 1), .end = length};
  return {.begin = begin, .end = begin + inside};
}

}  // namespace

ShownLine::ShownLine(std::string_view line, MarkedPart marked, std::size_t room)
    : line_(line),
      is_plain_(stays_as_it_is(line)),
      length_(is_plain_ ? line.size() : count_characters(line)),
      mark_(std::min(marked.begin, length_)),
      mark_end_(marked.end) {
  auto const window = window_around(mark_, std::max(mark_end_, mark_), length_, room);
  window_begin_ = window.begin;
  window_end_ = window.end;
}

template <class Take>
void ShownLine::for_each(std::size_t begin, std::size_t end, Take take) const {
  std::string_view rest = line_;
  for (std::size_t at = 0; at < end; ++at) {
    DecodedCharacter const character = decode_utf8(rest);
    rest.remove_prefix(character.size);
    if (at >= begin) take(character.value);
  }
}

void ShownLine::append_text(std::string& out) const {
  if (window_begin_ > 0) out += ellipsis;
  if (is_plain_) {
    out += line_.substr(window_begin_, window_end_ - window_begin_);
  } else {
    for_each(window_begin_, window_end_, [&out](char32_t character) {
      if (character == U'\t') {
        out += '\t';
      } else {
        append_printable(out, character);
      }
    });
  }
  if (window_end_ < length_) out += ellipsis;
}

void ShownLine::append_indent(std::string& out) const {
  if (window_begin_ > 0) out += ' ';
  std::size_t const end = std::min(mark_, window_end_);
  if (!is_plain_) {
    for_each(window_begin_, end, [&out](char32_t character) { out += character == U'\t' ? '\t' : ' '; });
    return;
  }
  std::string_view const before = line_.substr(window_begin_, end - window_begin_);
  std::size_t const begin = out.size();
  out.append(before.size(), ' ');
  for (std::size_t tab = before.find('\t'); tab != std::string_view::npos; tab = before.find('\t', tab + 1)) {
    out[begin + tab] = '\t';
  }
}

std::size_t ShownLine::width() const {
  std::size_t const end = std::min(mark_end_, window_end_);
  return end > mark_ ? end - mark_ : 1;
}

}  // namespace axisc
