// The reader of grammar/plain_lines.hpp: a line is cut by calculating with the bits of its first block.
//
// What differs from line to line (comment or none, one blank or many) is computed and not decided: a branch that the
// processor guesses wrong costs as much as a third of a line.
#pragma once

#include "grammar/levels/text_block_def.hpp"
#include "grammar/plain_lines.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

/// What several functions compute is computed once where all is one function.
#define AXISC_INLINE inline __attribute__((always_inline))

namespace axisc::grammar::AXISC_LEVEL {

inline constexpr std::uint32_t block_size = room_behind_line;
inline constexpr std::size_t bytes_ahead = 4096;

/// The place of the lowest bit; 63 where there is none. The one behind the highest; there is one.
inline std::uint32_t first_or_last_of(Bits bits) {
  return static_cast<std::uint32_t>(__builtin_ctzll(bits | Bits{1} << 63U));
}
inline std::uint32_t end_of(Bits bits) {
  return 64U - static_cast<std::uint32_t>(__builtin_clzll(bits));
}
inline Bits lowest(Bits bits) {
  return bits & (0 - bits);
}
/// The unbroken run that begins with the lowest bit: an addition carries through it.
inline Bits first_run(Bits bits) {
  return bits & ~(bits + lowest(bits));
}
/// Those of the first `count` places, also of more than there are.
inline Bits first_of(Bits bits, std::uint32_t count) {
#if defined(__BMI2__)
  return _bzhi_u64(bits, count < block_size ? count : block_size);
#else
  return count < block_size ? bits & ((Bits{1} << count) - 1) : bits;
#endif
}

/// Notes the lines that the unusual bytes of a block stand in; `line` is the one that reaches into the block.
__attribute__((noinline)) inline void note_unusual(Bits unusual, Bits line_feeds, bool* line) {
  for (; unusual != 0; unusual &= unusual - 1) {
    line[__builtin_popcountll(line_feeds & (lowest(unusual) - 1))] = true;
  }
}

inline void find_lines(char const* text, std::size_t size, std::uint32_t begin, PlainLines& lines) {
  std::uint32_t* const begins = lines.begins.data();
  bool* const unusual_lines = lines.unusual.data();
  std::memset(unusual_lines, 0, sizeof lines.unusual);
  begins[0] = begin;
  std::size_t count = 0;
  Bits returned = 0;  // The byte before the block is a carriage return.
  Bits letter_p = 0;  // The same of a P.
  Bits numbers = 0;
  for (std::size_t at = begin; at + block_size <= size && count < lines_at_once; at += block_size) {
    // A text that lay idle comes from farther away than a processor looks ahead by itself.
    __builtin_prefetch(text + (at + bytes_ahead < size ? at + bytes_ahead : at));
    TextBlock const block(text + at);
    Bits feeds = block.line_feed();
    Bits const others = block.unusual() & ~feeds;
    if ((others | returned) != 0) {
      Bits const returns = block.carriage_return();
      // A carriage return that no line feed follows stands in its line.
      Bits const unusual = (others & ~returns & ~block.blank()) | (((returns << 1U) | returned) & ~feeds);
      returned = returns >> 63U;
      if (unusual != 0) note_unusual(unusual, feeds, unusual_lines + count);
    }
    numbers |= (block.letter_p() << 1U | letter_p) & block.dash();
    letter_p = block.letter_p() >> 63U;
    // Hardly any block has more than three.
    std::uint32_t* next = begins + count + 1;
    count += static_cast<std::size_t>(__builtin_popcountll(feeds));
    auto const behind = static_cast<std::uint32_t>(at + 1);
    for (int i = 0; i < 3; ++i, feeds &= feeds - 1) *next++ = behind + first_or_last_of(feeds);
    for (; feeds != 0; feeds &= feeds - 1) *next++ = behind + first_or_last_of(feeds);
  }
  while (count != 0 && begins[count - 1] + std::size_t{block_size} > size) --count;
  lines.count = count;
  lines.may_name_numbers |= numbers != 0;
}

/// What a trailer's first byte says; a slash needs a second look. Where there is no trailer, blanks or the line's end stand
/// there.
struct TrailerKinds {
  constexpr TrailerKinds() {
    for (TrailerKind& kind : of) kind = TrailerKind::text;
    of[static_cast<unsigned char>('(')] = TrailerKind::parenthesis;
    of[static_cast<unsigned char>('#')] = TrailerKind::hash;
    for (char const byte : {' ', '\t', '\r', '\n'}) of[static_cast<unsigned char>(byte)] = TrailerKind::none;
  }
  TrailerKind of[256] = {};
};
inline constexpr TrailerKinds trailer_kinds{};

inline TrailerKind trailer_kind(char const* trailer) {
  if (trailer[0] == '/' && trailer[1] == '*') return TrailerKind::slash_star;
  return trailer_kinds.of[static_cast<unsigned char>(*trailer)];
}

inline bool is_blank(char byte) {
  return byte == ' ' || byte == '\t';
}

/// `Ende` in any letter case.
inline bool is_end_marker(char const* name, std::uint32_t size) {
  if (size != 4) return false;
  std::uint32_t word = 0;
  std::uint32_t marker = 0;
  std::memcpy(&word, name, sizeof word);
  std::memcpy(&marker, "ende", sizeof marker);
  return (word | 0x20202020U) == marker;
}

enum class Shape : std::uint8_t { irregular, silent, assignment };

/// The line at `origin` has `size` bytes before its line feed.
AXISC_INLINE Shape split_line(char const* text, std::uint32_t origin, std::uint32_t size, Assignment& out) {
  char const* const line = text + origin;
  size -= static_cast<std::uint32_t>(line[size - static_cast<std::uint32_t>(size != 0)] == '\r');
  while (size != 0 && is_blank(line[size - 1])) --size;
  Bits const content = first_of(TextBlock(line).content(), size);
  if (content == 0 || line[first_or_last_of(content)] == '#') {
    return content == 0 && size != 0 ? Shape::irregular : Shape::silent;
  }
  Bits const name = first_run(content);
  Bits const value = first_run(content ^ name);
  Bits const trailer = content ^ name ^ value;
  // A value that reaches the end of the block may go on behind it.
  if (value == 0 || (value >> 63U) != 0) return Shape::irregular;
  std::uint32_t const name_begin = first_or_last_of(name);
  std::uint32_t const name_end = end_of(name);
  std::uint32_t const value_begin = first_or_last_of(value);
  std::uint32_t trailer_begin = trailer == 0 ? size : first_or_last_of(trailer);
  if ((static_cast<unsigned>(trailer == 0) & static_cast<unsigned>(size > block_size)) != 0) {
    trailer_begin = block_size;
    while (is_blank(line[trailer_begin])) ++trailer_begin;
  }
  if (is_end_marker(line + name_begin, name_end - name_begin)) return Shape::irregular;

  out.name = {.begin = origin + name_begin, .end = origin + name_end};
  out.value = {.begin = origin + value_begin, .end = origin + end_of(value)};
  out.trailer = {.begin = origin + trailer_begin, .end = origin + size};
  out.trailer_kind = trailer_kind(line + trailer_begin);
  return Shape::assignment;
}

inline std::size_t split_lines(char const* text, PlainLines const& lines, std::size_t& given_next,
                               Assignment* out, std::size_t room) {
  std::uint32_t const* const begins = lines.begins.data();
  bool const* const unusual = lines.unusual.data();
  std::size_t count = 0;
  std::size_t next = given_next;  // Nobody else changes it.
  for (; next < lines.count && count < room; ++next) {
    if (unusual[next]) break;
    std::uint32_t const begin = begins[next];
    Shape const shape = split_line(text, begin, begins[next + 1] - begin - 1, out[count]);
    if (shape == Shape::irregular) break;
    out[count].line = lines.lines_before + static_cast<std::uint32_t>(next) + 1;
    count += static_cast<std::size_t>(shape == Shape::assignment);
  }
  given_next = next;
  return count;
}

}  // namespace axisc::grammar::AXISC_LEVEL
