// One line of a source as the text format shows it, with the markers under it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace axisc {

/// Code points [begin, end) of a line, counted from 0; the marked part.
struct MarkedPart {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Tabs are kept, in the line and in the indent, so that any terminal aligns both alike.
class ShownLine {
 public:
  /// `line` is UTF-8 and must outlive this object. At most `room` characters are shown, "…" where the line is
  /// cut included.
  ShownLine(std::string_view line, MarkedPart marked, std::size_t room);

  /// Printable.
  void append_text(std::string& out) const;
  /// As wide as the text before the marked part: blanks, and the tabs of the line.
  void append_indent(std::string& out) const;
  /// Characters of the marked part that are shown; 1 for an empty part.
  [[nodiscard]] std::size_t width() const;

 private:
  /// The characters [begin, end) of the line.
  template <class Take>
  void for_each(std::size_t begin, std::size_t end, Take take) const;

  std::string_view line_;
  bool is_plain_;                 ///< every byte is a character that stays as it is
  std::size_t length_;            ///< in characters, as all that follow
  std::size_t mark_;              ///< begin of the marked part
  std::size_t mark_end_;          ///< its end, or the end of the line
  std::size_t window_begin_ = 0;  ///< the part shown
  std::size_t window_end_ = 0;
};

}  // namespace axisc
