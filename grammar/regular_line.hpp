// Lines as nearly all of them are, read without the grammar: blank lines, comments, and `name value [trailer]` with a plain
// number or word. The grammar stays the authority: whatever looks unusual here is left to it, and a line that is read here
// reads the same there (tests/grammar/regular_line.test.cpp).
#pragma once

#include "grammar/axis_list.hpp"

#include <cstdint>

namespace axisc::grammar {

struct RegularLine {
  enum class Shape : std::uint8_t {
    irregular,  ///< ask the grammar; nothing else is set, and the line begins where it began
    blank,
    comment,     ///< from `#` to the line's end: `assignment.trailer`
    assignment,  ///< all spans and kinds of `assignment`; not its line
  };
  Shape shape = Shape::irregular;
  char const* next = nullptr;  ///< behind the line end
  Assignment assignment;
};

/// Reads the line that begins at `line` in the text from `text` to `end`; spans count from `text`. At least
/// TextBlock::size bytes follow `line`. `Ende` and everything behind it are irregular.
[[nodiscard]] RegularLine read_regular_line(char const* text, char const* line, char const* end,
                                            bool windows_1252);

}  // namespace axisc::grammar
