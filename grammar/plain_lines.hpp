// Lines as nearly all of them are, taken apart without the grammar: blank lines, comments, and `name value
// [trailer]`.
//
// They are cut at their blanks and no more: the caller, which knows the parameters, finds out whether the
// name is one, what the value is and whether the grammar would read the line like this. The grammar stays the
// authority, and how tokens are spelled is stated once for both (lexical.hpp): a line that is read without
// the grammar reads the same with it (tests/validator/list_reader.test.cpp, tests/fuzz/axis_list.fuzz.cpp).
#pragma once

#include "grammar/axis_list.hpp"
#include "grammar/lexical.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace axisc::grammar {

/// At least this many bytes of the text follow the beginning of every line that is found.
inline constexpr std::size_t room_behind_line = 64;
/// As many lines as a cache holds together with the data made from them.
inline constexpr std::size_t lines_at_once = 256;
/// Bytes that lines are searched in at once.
inline constexpr std::size_t bytes_at_once = 32768;

/// Consecutive lines of a text.
struct PlainLines {
  static constexpr std::size_t room = lines_at_once + room_behind_line;

  /// The beginning of each line; that of the next one is the byte after its line feed.
  std::array<std::uint32_t, room + 4> begins;
  /// The line has a byte that hardly any line has: a control character, one above 0x7E, a colon (which a
  /// directive needs). The grammar has to look at it.
  std::array<bool, room + 4> unusual;
  /// Bytes that are neither blank nor line end, one bit a byte, from the begin of the first line on.
  std::array<std::uint64_t, bytes_at_once / 64 + 1> content;
  std::size_t count = 0;
  std::uint32_t lines_before = 0;  ///< in the text
  /// "P-" is in these lines or in those that were found before, as in the number of a parameter.
  bool may_name_numbers = false;

  /// Without its line end.
  [[nodiscard]] std::string_view line(std::string_view text, std::size_t index) const {
    std::string_view line = text.substr(begins[index], begins[index + 1] - 1 - begins[index]);
    if (line.ends_with(lexical::carriage_return)) line.remove_suffix(1);
    return line;
  }
  [[nodiscard]] std::uint32_t number(std::size_t index) const {
    return lines_before + static_cast<std::uint32_t>(index) + 1;
  }
};

/// Finds the lines from `begin` on, about lines_at_once of them; none near the end of the text, and none
/// where the first is longer than bytes_at_once. Offsets have 32 bits. Cost: one pass over these lines.
void find_lines(std::string_view text, std::uint32_t begin, PlainLines& lines);

/// Takes lines apart from `next` on, up to the first that is not a plain one (a single word, a token that may
/// continue after its first 64 bytes, an unusual byte, `Ende`), to the last, or until `out` is full: all but
/// their kind. Returns the number of assignments.
[[nodiscard]] std::size_t split_lines(std::string_view text, PlainLines const& lines, std::size_t& next,
                                      std::span<Assignment> out);

}  // namespace axisc::grammar
