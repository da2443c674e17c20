// One line of a source as the text form shows it, with what stands under it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace axisc {

/// Code points [begin, end) of a line, counted from 0; the part that is pointed at.
struct MarkedPart {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct ShownLine {
  std::string text;  ///< printable, at most `longest_shown_line` characters of the line, "…" where it was cut
  std::string indent;     ///< as wide as the text before the marked part: blanks, and the tabs of the line
  std::size_t width = 1;  ///< characters of the marked part that are shown; 1 for an empty part
};

/// In code points. Lists are written by people: longer lines are data or accidents.
inline constexpr std::size_t longest_shown_line = 160;

/// `line` is UTF-8. Tabs stay tabs, in the line and in the indent, so that any terminal aligns both alike.
[[nodiscard]] ShownLine show_line(std::string_view line, MarkedPart marked);

}  // namespace axisc
