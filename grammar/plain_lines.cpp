// A line is cut by calculating with one bit for each of its bytes.
//
// Differences between lines (comment or none, one blank or many) are computed without branches: a branch that
// the processor guesses wrong costs as much as a third of a line.
#include "grammar/plain_lines.hpp"

#include "grammar/text_block.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace axisc::grammar {
namespace {

constexpr std::uint32_t text_block_size = TextBlock::size;
constexpr std::size_t bytes_ahead = 4096;
static_assert(room_behind_line == text_block_size && bytes_at_once % text_block_size == 0);

/// The place of the lowest bit; 63 where there is none.
std::uint32_t first_or_last_of(Bits bits) {
  return static_cast<std::uint32_t>(__builtin_ctzll(bits | Bits{1} << 63U));
}
/// The place after the highest bit; there is one.
std::uint32_t end_of(Bits bits) {
  return 64U - static_cast<std::uint32_t>(__builtin_clzll(bits));
}
Bits lowest(Bits bits) {
  return bits & (0 - bits);
}
/// The unbroken run that begins with the lowest bit: an addition carries through it.
Bits first_run(Bits bits) {
  return bits & ~(bits + lowest(bits));
}
/// Those of the first `count` places, which may be more than there are.
Bits first_of(Bits bits, std::uint32_t count) {
  return count < text_block_size ? bits & ((Bits{1} << count) - 1) : bits;
}

/// Notes the lines that contain unusual bytes of a block; `line` is the one that reaches into the block.
[[gnu::noinline]] void note_unusual(TextBlock const& block, Bits line_feeds, bool* line) {
  for (Bits unusual = block.unusual(); unusual != 0; unusual &= unusual - 1) {
    line[std::popcount(line_feeds & (lowest(unusual) - 1))] = true;
  }
}

/// The kind of a trailer by its first byte; a slash needs a second look. Where there is no trailer, the byte
/// is a blank or the line's end.
constexpr std::array<TrailerKind, 256> trailer_kinds = [] {
  std::array<TrailerKind, 256> kinds{};
  kinds.fill(TrailerKind::text);
  auto const of = [&kinds](char byte) -> TrailerKind& { return kinds[static_cast<unsigned char>(byte)]; };
  of(lexical::parenthesis) = TrailerKind::parenthesis;
  of(lexical::hash) = TrailerKind::hash;
  for (char const byte : {' ', '\t', lexical::carriage_return, lexical::line_feed}) {
    of(byte) = TrailerKind::none;
  }
  return kinds;
}();

TrailerKind trailer_kind(char const* trailer) {
  if (trailer[0] == lexical::slash_star[0] && trailer[1] == lexical::slash_star[1]) {
    return TrailerKind::slash_star;
  }
  return trailer_kinds[static_cast<unsigned char>(*trailer)];
}

enum class Shape : std::uint8_t { irregular, silent, assignment };

/// The line at `origin` has `size` bytes before its line feed; `window` are its first bytes that are content,
/// and those of the lines after it.
[[gnu::always_inline]] inline Shape split_line(char const* text, std::uint32_t origin, std::uint32_t size,
                                               Bits window, Assignment& out) {
  char const* const line = text + origin;
  Bits const content = first_of(window, size);
  bool const is_long = size > text_block_size;
  if (is_long) {
    if (line[size - 1] == lexical::carriage_return) --size;
    while (size != 0 && is(character::blank, line[size - 1])) --size;
  }
  if (content == 0) return is_long && size != 0 ? Shape::irregular : Shape::silent;
  if (line[first_or_last_of(content)] == lexical::hash) return Shape::silent;
  if (!is_long) size = end_of(content);
  Bits const name = first_run(content);
  Bits const value = first_run(content ^ name);
  Bits const trailer = content ^ name ^ value;
  // A value that reaches the end of the block may continue after it.
  if (value == 0 || (value >> 63U) != 0) return Shape::irregular;
  std::uint32_t const name_begin = first_or_last_of(name);
  std::uint32_t const name_end = end_of(name);
  std::uint32_t const value_begin = first_or_last_of(value);
  std::uint32_t trailer_begin = trailer == 0 ? size : first_or_last_of(trailer);
  if ((static_cast<unsigned>(trailer == 0) & static_cast<unsigned>(size > text_block_size)) != 0) {
    trailer_begin = text_block_size;
    while (is(character::blank, line[trailer_begin])) ++trailer_begin;
  }
  if (lexical::is_end_marker({line + name_begin, name_end - name_begin})) return Shape::irregular;

  out.name = {.begin = origin + name_begin, .end = origin + name_end};
  out.value = {.begin = origin + value_begin, .end = origin + end_of(value)};
  out.trailer = {.begin = origin + trailer_begin, .end = origin + size};
  out.trailer_kind = trailer_kind(line + trailer_begin);
  return Shape::assignment;
}

}  // namespace

void find_lines(std::string_view text, std::uint32_t begin, PlainLines& lines) {
  std::uint32_t* const begins = lines.begins.data();
  lines.unusual.fill(false);
  begins[0] = begin;
  std::size_t count = 0;
  bool may_name_numbers = false;
  Bits* content = lines.content.data();
  std::size_t const end = std::min(text.size(), begin + bytes_at_once + 1);
  for (std::size_t at = begin; at + text_block_size < end && count < lines_at_once; at += text_block_size) {
    // A text that lay idle comes from farther away than a processor looks ahead by itself.
    __builtin_prefetch(text.data() + std::min(at + bytes_ahead, text.size()));
    TextBlock const block(text.data() + at);
    auto [feeds, visible] = block.layout();
    *content++ = visible;
    if (block.has_unusual()) note_unusual(block, feeds, lines.unusual.data() + count);
    may_name_numbers |= block.may_name_numbers();
    // Hardly any block has more than three.
    auto const behind = static_cast<std::uint32_t>(at + 1);
    for (int i = 0; i < 3; ++i, feeds &= feeds - 1) {
      begins[count + 1] = behind + first_or_last_of(feeds);
      count += static_cast<std::size_t>(feeds != 0);
    }
    for (; feeds != 0; feeds &= feeds - 1) begins[++count] = behind + first_or_last_of(feeds);
  }
  *content = 0;
  while (count != 0 && begins[count - 1] + room_behind_line > text.size()) --count;
  lines.count = count;
  lines.may_name_numbers |= may_name_numbers;
}

std::size_t split_lines(std::string_view text, PlainLines const& lines, std::size_t& next,
                        std::span<Assignment> out) {
  std::uint32_t const* const begins = lines.begins.data();
  std::size_t count = 0;
  std::size_t index = next;  // A copy, which no write through a pointer can change.
  for (; index < lines.count && count < out.size(); ++index) {
    if (lines.unusual[index]) break;
    std::uint32_t const begin = begins[index];
    Bits const* const content = lines.content.data() + (begin - begins[0]) / text_block_size;
    std::uint32_t const shift = (begin - begins[0]) % text_block_size;
    Bits const window = content[0] >> shift | content[1] << 1U << (63U - shift);
    Shape const shape = split_line(text.data(), begin, begins[index + 1] - begin - 1, window, out[count]);
    if (shape == Shape::irregular) break;
    out[count].line = lines.number(index);
    count += static_cast<std::size_t>(shape == Shape::assignment);
  }
  next = index;
  return count;
}

}  // namespace axisc::grammar
