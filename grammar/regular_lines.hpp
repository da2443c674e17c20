// Lines as nearly all of them are, read without the grammar: blank lines, comments, and `name value [trailer]` with a plain
// number or word. The grammar stays the authority: whatever looks unusual here is left to it, and a line that is read here
// reads the same there (tests/grammar/regular_lines.test.cpp).
//
// The reader is compiled once for each width of the processor's vectors (grammar/levels).
#pragma once

#include "grammar/axis_list.hpp"

#include <cstddef>
#include <cstdint>

namespace axisc::grammar {

/// So many bytes follow the begin of every line that is read here.
inline constexpr std::size_t room_behind_line = 64;

/// How far a text has been read.
struct RegularLines {
  char const* text = nullptr;  ///< spans count from here
  char const* line = nullptr;  ///< the next line
  /// A line that begins here or behind is not read; room_behind_line before `end` or earlier.
  char const* stop = nullptr;
  char const* end = nullptr;  ///< of the text
  std::uint32_t number = 0;   ///< of the line before `line`
  bool windows_1252 = false;
};

/// Reads lines up to the first irregular one, up to `stop`, or until `room` assignments are written to `out`. Gives the
/// number of assignments. `Ende` is irregular.
using RegularLineReader = std::size_t (*)(RegularLines& lines, Assignment* out, std::size_t room);

/// Null for the grammar, and for a way that this processor cannot go.
[[nodiscard]] RegularLineReader find_regular_line_reader(Way way);

}  // namespace axisc::grammar
