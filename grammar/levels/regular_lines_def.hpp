// The reader of grammar/regular_lines.hpp: a line is taken apart by calculating with the bits of its first block.
//
// What differs from line to line (comment or none, real or integer) is computed and not decided: a branch that the
// processor guesses wrong costs as much as half a line.
#pragma once

#include "grammar/invalid_character.hpp"
#include "grammar/levels/text_block_def.hpp"
#include "grammar/levels/tokens_def.hpp"
#include "grammar/regular_lines.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace axisc::grammar::AXISC_LEVEL {

inline constexpr std::ptrdiff_t block_size = room_behind_line;

/// Of what stands behind the first block.
struct Rest {
  bool has_unusual = false;
  bool has_mark = false;  ///< a quote or a round parenthesis
};

/// The blocks lie from the line's end backwards, so the first one may overlap the line's first block. That does no harm:
/// what is unusual there is looked at again, and a mark would have been found before.
inline Rest look_at_rest(char const* line, char const* end) {
  Bits unusual = 0;
  Bits marks = 0;
  for (char const* place = end - block_size; place > line; place -= block_size) {
    TextBlock const block(place);
    unusual |= block.unusual() & ~block.blank();
    marks |= block.mark();
  }
  return {.has_unusual = unusual != 0, .has_mark = marks != 0};
}

enum class Shape : std::uint8_t { irregular, silent, assignment };

class LineReader {
 public:
  LineReader(RegularLines const& lines, char const* line)
      : text_(lines.text), line_(line), windows_1252_(lines.windows_1252), block_(line) {
    find_end(lines.end);
  }

  [[nodiscard]] char const* next() const { return next_; }

  /// Writes spans and kinds of an assignment, all but its line.
  AXISC_INLINE Shape read(Assignment& out) const {
    if (next_ == nullptr) return Shape::irregular;
    if (content_ == 0) return is_long() ? Shape::irregular : Shape::silent;
    unsigned const begin = first_of(content_);
    if (line_[begin] == '#') return is_clean_from(begin, content_) ? Shape::silent : Shape::irregular;
    return read_assignment(out) ? Shape::assignment : Shape::irregular;
  }

 private:
  /// Where the line ends, without line end and trailing blanks.
  void find_end(char const* text_end) {
    Bits const line_feed = lowest(block_.line_feed());
    Bits const blank = block_.blank();
    if (line_feed == 0) return find_far_end(text_end, blank);
    next_ = line_ + first_of(line_feed) + 1;
    content_ = (line_feed - 1) & ~blank & ~(block_.carriage_return() & (line_feed >> 1U));
    end_ = line_ + (content_ == 0 ? 0U : end_of(content_));
  }

  /// No line feed in the block.
  void find_far_end(char const* text_end, Bits blank) {
    char const* const line_feed = find_line_feed(line_ + block_size, text_end);
    if (line_feed == nullptr) return;
    next_ = line_feed + 1;
    end_ = line_feed;
    if (end_[-1] == '\r') --end_;
    while (end_ != line_ && (end_[-1] == ' ' || end_[-1] == '\t')) --end_;
    content_ = ~blank;
    if (end_ - line_ < block_size) content_ &= (Bits{1} << static_cast<unsigned>(end_ - line_)) - 1;
  }

  static char const* find_line_feed(char const* from, char const* text_end) {
    if (text_end - from >= block_size) {
      Bits const line_feed = TextBlock(from).line_feed();
      if (line_feed != 0) return from + first_of(line_feed);
    }
    return static_cast<char const*>(std::memchr(from, '\n', static_cast<std::size_t>(text_end - from)));
  }

  /// The line ends outside of the block.
  [[nodiscard]] bool is_long() const { return end_ - line_ > block_size; }

  /// Every character from `begin` on is allowed. `bits` are those in the block; `begin` is no place inside a character.
  [[nodiscard]] bool is_clean_from(unsigned begin, Bits bits) const {
    bool unusual = (block_.unusual() & bits) != 0;
    if (is_long()) unusual = unusual || look_at_rest(line_, end_).has_unusual;
    return !unusual || is_allowed(line_ + begin, end_, windows_1252_);
  }

  AXISC_INLINE bool read_assignment(Assignment& out) const {
    Bits const name = first_run(content_);
    Bits const value = first_run(content_ ^ name);
    Bits const trailer = content_ ^ name ^ value;
    Bits const value_beginning = lowest(value);
    // No value, or one that reaches the end of the block.
    if (value == 0 || (value >> 63U) != 0) return false;
    unsigned const name_begin = first_of(name);
    unsigned const name_end = end_of(name);
    Bits const marks = block_.mark();
    Bits const unusual_bytes = block_.unusual();
    Bits const wrong = wrong_in_name(block_, name) | (value & (marks | unusual_bytes));
    if (wrong != 0 || is_end_marker(line_ + name_begin, name_end - name_begin)) return false;

    unsigned const value_begin = first_of(value);
    unsigned const value_end = end_of(value);
    if (!read_value(value, value_beginning, out.kind)) return false;

    Bits const mark = lowest(trailer & marks);
    // Quotes may protect a parenthesis.
    if (line_[first_or_last_of(mark)] == '"' && mark != 0) return false;
    // A choice between two pointers would become a branch.
    std::ptrdiff_t const behind_trailer = end_ - (line_ + first_or_last_of(trailer));
    char const* trailer_begin = end_ - behind_trailer * static_cast<std::ptrdiff_t>(trailer != 0);
    char const* free_text_end = line_ + end_of(content_ & (mark - 1));
    bool unusual = (trailer & unusual_bytes) != 0;
    if (is_long()) {
      Rest const rest = look_at_rest(line_, end_);
      unusual = unusual || rest.has_unusual;
      if (mark == 0) {
        if (rest.has_mark) return false;
        free_text_end = end_;
      }
      if (trailer == 0) trailer_begin = behind_blanks(line_ + block_size);
    }
    if (unusual && !is_allowed(line_ + value_end, end_, windows_1252_)) return false;

    out.name = span(line_ + name_begin, line_ + name_end);
    out.value = span(line_ + value_begin, line_ + value_end);
    out.trailer = span(trailer_begin, end_);
    out.free_text = span(line_ + value_begin, free_text_end);
    out.trailer_kind = trailer_kind(trailer_begin, end_);
    return true;
  }

  /// False for what the grammar has to look at.
  AXISC_INLINE bool read_value(Bits token, Bits beginning, ValueKind& kind) const {
    char const* const text = line_ + first_of(token);
    Bits const letter = block_.letter() & token;
    Bits const number = token & ~(Bits{is_sign(*text)} * beginning);
    bool const is_word = (letter & beginning) != 0;
    if (!is_word && letter != 0) {
      kind = kind_with_letters(block_, line_, token, number, letter);
      return kind != ValueKind::word;
    }
    bool const is_reference = text[0] == 'P' && text[1] == '-';
    Bits const point = block_.point();
    ValueKind const number_kind = (point & token) != 0 ? ValueKind::real : ValueKind::integer;
    kind = is_word ? ValueKind::word : number_kind;
    return is_word ? !is_reference : number != 0 && is_decimal(block_.digit(), point, line_, number);
  }

  static char const* behind_blanks(char const* place) {
    while (*place == ' ' || *place == '\t') ++place;
    return place;
  }

  [[nodiscard]] Span span(char const* begin, char const* end) const {
    return {.begin = static_cast<std::uint32_t>(begin - text_),
            .end = static_cast<std::uint32_t>(end - text_)};
  }

  char const* text_;
  char const* line_;
  bool windows_1252_;
  TextBlock block_;
  char const* end_ = nullptr;
  char const* next_ = nullptr;  ///< null in a last line without line end
  Bits content_ = 0;            ///< the bytes of the block that belong to the line and are not blank
};

/// What each level defines for grammar/regular_lines.cpp.
std::size_t read_regular_lines(RegularLines& lines, Assignment* out, std::size_t room);

inline std::size_t read_lines(RegularLines& lines, Assignment* out, std::size_t room) {
  std::size_t count = 0;
  while (lines.line < lines.stop && count < room) {
    LineReader const reader(lines, lines.line);
    Shape const shape = reader.read(out[count]);
    if (shape == Shape::irregular) break;
    lines.line = reader.next();
    ++lines.number;
    if (shape == Shape::assignment) out[count++].line = lines.number;
  }
  return count;
}

}  // namespace axisc::grammar::AXISC_LEVEL
