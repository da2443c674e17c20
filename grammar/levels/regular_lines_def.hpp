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

/// Nearly all lines end inside of their first block; of the others more has to be looked at.
enum class Reach : std::uint8_t { block, further };

template <Reach reach>
class LineReader {
 public:
  /// `content` are the bytes of the line in the block that are not blank; the line without trailing blanks has `size` bytes.
  LineReader(RegularLines const& lines, TextBlock const& block, Bits content, std::size_t size)
      : line_(lines.line),
        origin_(static_cast<std::uint32_t>(lines.line - lines.text)),
        windows_1252_(lines.windows_1252),
        block_(block),
        content_(content),
        size_(static_cast<std::uint32_t>(size)) {}

  /// Writes spans and kinds of an assignment, all but its line.
  AXISC_INLINE Shape read(Assignment& out) const {
    if (content_ == 0) return is_long() ? Shape::irregular : Shape::silent;
    unsigned const begin = first_of(content_);
    if (line_[begin] == '#') return is_clean_from(begin, content_) ? Shape::silent : Shape::irregular;
    return read_assignment(out) ? Shape::assignment : Shape::irregular;
  }

 private:
  /// The line ends outside of the block.
  [[nodiscard]] bool is_long() const { return reach == Reach::further && size_ > block_size; }

  /// Every character from `begin` on is allowed. `bits` are those in the block; `begin` is no place inside a character.
  [[nodiscard]] AXISC_INLINE bool is_clean_from(unsigned begin, Bits bits) const {
    bool unusual = (block_.unusual() & bits) != 0;
    if (is_long()) unusual = unusual || look_at_rest(line_, line_ + size_).has_unusual;
    return !unusual || is_allowed(line_ + begin, line_ + size_, windows_1252_);
  }

  AXISC_INLINE bool read_assignment(Assignment& out) const {
    Bits const name = first_run(content_);
    Bits const value = first_run(content_ ^ name);
    Bits const trailer = content_ ^ name ^ value;
    if (value == 0) return false;
    // One that reaches the end of the block may go on behind it.
    if (reach == Reach::further && (value >> 63U) != 0) return false;
    std::uint32_t const name_begin = first_of(name);
    std::uint32_t const name_end = end_of(name);
    Bits const marks = block_.mark();
    Bits const unusual_bytes = block_.unusual();
    Bits const wrong = wrong_in_name(block_, name) | (value & (marks | unusual_bytes));
    if (wrong != 0 || is_end_marker(line_ + name_begin, name_end - name_begin)) return false;

    std::uint32_t const value_begin = first_of(value);
    std::uint32_t const value_end = end_of(value);
    if (!read_value(value, out.kind)) return false;

    Bits const mark = lowest(trailer & marks);
    // Quotes may protect a parenthesis.
    if (line_[first_or_last_of(mark)] == '"' && mark != 0) return false;
    std::uint32_t free_text_end = end_of(content_ & (mark - 1));
    std::uint32_t trailer_begin = 0;
    bool unusual = (trailer & unusual_bytes) != 0;
    if constexpr (reach == Reach::block) {
      // Where there is none it begins at the line's end.
      trailer_begin = first_of(trailer | Bits{1} << size_);
    } else {
      trailer_begin = trailer == 0 ? size_ : first_of(trailer);
    }
    if (is_long()) {
      Rest const rest = look_at_rest(line_, line_ + size_);
      unusual = unusual || rest.has_unusual;
      if (mark == 0) {
        if (rest.has_mark) return false;
        free_text_end = size_;
      }
      if (trailer == 0) trailer_begin = behind_blanks(block_size);
    }
    if (unusual && !is_allowed(line_ + value_end, line_ + size_, windows_1252_)) return false;

    out.name = span(name_begin, name_end);
    out.value = span(value_begin, value_end);
    out.trailer = span(trailer_begin, size_);
    out.free_text = span(value_begin, free_text_end);
    out.trailer_kind = trailer_kind(line_ + trailer_begin);
    return true;
  }

  /// False for what the grammar has to look at.
  AXISC_INLINE bool read_value(Bits token, ValueKind& kind) const {
    char const* const text = line_ + first_of(token);
    Bits const beginning = lowest(token);
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

  [[nodiscard]] std::uint32_t behind_blanks(std::uint32_t place) const {
    while (line_[place] == ' ' || line_[place] == '\t') ++place;
    return place;
  }

  /// Of places in the line.
  [[nodiscard]] Span span(std::uint32_t begin, std::uint32_t end) const {
    return {.begin = origin_ + begin, .end = origin_ + end};
  }

  char const* line_;
  std::uint32_t origin_;  ///< of the line in the text
  bool windows_1252_;
  TextBlock block_;
  Bits content_;
  std::uint32_t size_;
};

inline char const* find_line_feed(char const* from, char const* text_end) {
  if (text_end - from >= block_size) {
    Bits const line_feed = TextBlock(from).line_feed();
    if (line_feed != 0) return from + first_of(line_feed);
  }
  return static_cast<char const*>(std::memchr(from, '\n', static_cast<std::size_t>(text_end - from)));
}

/// A line without line feed in its first block. A last line without line end is irregular.
AXISC_INLINE Shape read_far_line(RegularLines& lines, TextBlock const& block, Assignment& out) {
  char const* const line = lines.line;
  char const* const line_feed = find_line_feed(line + block_size, lines.end);
  if (line_feed == nullptr) return Shape::irregular;
  char const* end = line_feed;
  if (end[-1] == '\r') --end;
  while (end != line && (end[-1] == ' ' || end[-1] == '\t')) --end;
  Bits content = ~block.blank();
  if (end - line < block_size) content &= (Bits{1} << static_cast<unsigned>(end - line)) - 1;
  auto const size = static_cast<std::size_t>(end - line);
  Shape const shape = LineReader<Reach::further>(lines, block, content, size).read(out);
  if (shape != Shape::irregular) lines.line = line_feed + 1;
  return shape;
}

/// Goes on behind the line unless it is irregular.
AXISC_INLINE Shape read_next_line(RegularLines& lines, Assignment& out) {
  TextBlock const block(lines.line);
  Bits const line_feed = lowest(block.line_feed());
  if (line_feed == 0) return read_far_line(lines, block, out);
  Bits const content = (line_feed - 1) & ~block.blank() & ~(block.carriage_return() & (line_feed >> 1U));
  std::size_t const size = content == 0 ? 0 : end_of(content);
  Shape const shape = LineReader<Reach::block>(lines, block, content, size).read(out);
  if (shape != Shape::irregular) lines.line += first_of(line_feed) + 1;
  return shape;
}

/// What each level defines for grammar/regular_lines.cpp.
std::size_t read_regular_lines(RegularLines& lines, Assignment* out, std::size_t room);

inline std::size_t read_lines(RegularLines& given, Assignment* out, std::size_t room) {
  RegularLines lines = given;  // Nobody else changes these.
  std::size_t count = 0;
  while (lines.line < lines.stop && count < room) {
    Shape const shape = read_next_line(lines, out[count]);
    if (shape == Shape::irregular) break;
    ++lines.number;
    if (shape == Shape::assignment) out[count++].line = lines.number;
  }
  given = lines;
  return count;
}

}  // namespace axisc::grammar::AXISC_LEVEL
