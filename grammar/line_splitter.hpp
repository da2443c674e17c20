// Cuts a text into lines. The line end is where reading starts afresh after a mistake, so it is found before
// any grammar looks at the text.
#pragma once

#include "grammar/lexical.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace axisc::grammar {

/// Lines end with LF, CR LF, or at the end of the text; a CR at the very end of the text is taken for half a
/// line end. Any other CR stays in its line.
class LineSplitter {
 public:
  /// `lines_before` of the file come before `text`.
  explicit LineSplitter(std::string_view text, std::uint32_t lines_before = 0)
      : position_(text.data()), end_(text.data() + text.size()), number_(lines_before) {}

  /// The next line without its line end; false after the last one. A text that ends with a line end has no
  /// empty line after it.
  [[nodiscard]] bool next(std::string_view& line) {
    if (position_ == end_) return false;
    auto const remaining = static_cast<std::size_t>(end_ - position_);
    auto const* const line_feed =
        static_cast<char const*>(std::memchr(position_, lexical::line_feed, remaining));
    char const* const line_end = line_feed != nullptr ? line_feed : end_;
    line = {position_, static_cast<std::size_t>(line_end - position_)};
    if (!line.empty() && line.back() == lexical::carriage_return) line.remove_suffix(1);
    position_ = line_feed != nullptr ? line_feed + 1 : end_;
    ++number_;
    return true;
  }

  /// To be called when other code has read the lines before `position`; `number` is that of the last one.
  void go_on_at(char const* position, std::uint32_t number) {
    position_ = position;
    number_ = number;
  }

  /// Where the next line begins.
  [[nodiscard]] char const* position() const { return position_; }
  [[nodiscard]] bool at_end() const { return position_ == end_; }

  /// Number of the line that next() returned last, from 1.
  [[nodiscard]] std::uint32_t number() const { return number_; }

 private:
  char const* position_;
  char const* end_;
  std::uint32_t number_;
};

}  // namespace axisc::grammar
