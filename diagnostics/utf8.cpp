#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace axisc {
namespace {

// Bytes that may follow a lead byte: table 3-7 of the Unicode standard. Only the second byte has a range of
// its own.
struct Sequence {
  std::size_t size;
  unsigned char second_least;
  unsigned char second_most;
};

constexpr Sequence sequence_of(unsigned char lead) {
  if (lead < 0x80) return {1, 0, 0};
  if (lead < 0xC2) return {0, 0, 0};
  if (lead < 0xE0) return {2, 0x80, 0xBF};
  if (lead == 0xE0) return {3, 0xA0, 0xBF};
  if (lead == 0xED) return {3, 0x80, 0x9F};
  if (lead < 0xF0) return {3, 0x80, 0xBF};
  if (lead == 0xF0) return {4, 0x90, 0xBF};
  if (lead < 0xF4) return {4, 0x80, 0xBF};
  if (lead == 0xF4) return {4, 0x80, 0x8F};
  return {0, 0, 0};
}

std::size_t well_formed_size(std::string_view text) {
  if (text.empty()) return 0;
  Sequence const sequence = sequence_of(static_cast<unsigned char>(text.front()));
  if (sequence.size <= 1) return sequence.size;
  if (text.size() < sequence.size) return 0;
  auto const second = static_cast<unsigned char>(text[1]);
  if (second < sequence.second_least || second > sequence.second_most) return 0;
  for (char const byte : text.substr(2, sequence.size - 2)) {
    if (!is_continuation_byte(byte)) return 0;
  }
  return sequence.size;
}

bool are_eight_ascii(char const* bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return (word & 0x8080808080808080U) == 0;
}

constexpr std::size_t piece = 256;

/// In pieces of a fixed size, so that compilers take many bytes at once.
bool is_ascii_piece(char const* bytes) {
  std::uint64_t any = 0;
  for (std::size_t i = 0; i < piece; i += sizeof any) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + i, sizeof word);
    any |= word;
  }
  return (any & 0x8080808080808080U) == 0;
}

}  // namespace

std::size_t ascii_prefix(std::string_view text) {
  std::size_t at = 0;
  while (text.size() - at >= piece && is_ascii_piece(text.data() + at)) at += piece;
  while (text.size() - at >= 8 && are_eight_ascii(text.data() + at)) at += 8;
  if (text.size() - at >= 8) return at;
  // The last eight bytes at once; some of them are examined twice.
  if (text.size() >= 8 && are_eight_ascii(text.data() + text.size() - 8)) return text.size();
  while (at < text.size() && static_cast<unsigned char>(text[at]) < 0x80) ++at;
  return at;
}

std::size_t valid_utf8_prefix(std::string_view text) {
  std::size_t at = 0;
  while (true) {
    at += ascii_prefix(text.substr(at));
    if (at == text.size()) break;
    std::size_t const size = well_formed_size(text.substr(at));
    if (size == 0) break;
    at += size;
  }
  return at;
}

std::size_t count_continuation_bytes(std::string_view text) {
  constexpr std::uint64_t ones = 0x0101010101010101U;
  std::size_t count = 0;
  for (; text.size() >= sizeof(std::uint64_t); text.remove_prefix(sizeof(std::uint64_t))) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, text.data(), sizeof bytes);
    // The uppermost bit of each byte is set and the one below is not.
    std::uint64_t const found = (bytes >> 7U) & (~bytes >> 6U) & ones;
    count += static_cast<std::size_t>((found * ones) >> 56U);
  }
  return count + static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_continuation_byte));
}

DecodedCharacter decode_utf8(std::string_view text) {
  if (text.empty()) return {};
  std::size_t const size = well_formed_size(text);
  if (size == 0) return {.value = replacement_character, .size = 1};
  constexpr std::array<unsigned, 5> payload_of_lead{0, 0x7F, 0x1F, 0x0F, 0x07};
  char32_t value = static_cast<unsigned char>(text.front()) & payload_of_lead.at(size);
  for (char const byte : text.substr(1, size - 1)) {
    value = (value << 6U) | (static_cast<unsigned char>(byte) & 0x3FU);
  }
  return {.value = value, .size = size};
}

void append_utf8(std::string& text, char32_t character) {
  bool const is_surrogate = character >= 0xD800 && character <= 0xDFFF;
  char32_t const value = is_surrogate || character > 0x10FFFF ? replacement_character : character;
  auto const continuation = [value](unsigned shift) {
    return static_cast<char>(0x80U | ((value >> shift) & 0x3FU));
  };
  if (value < 0x80) {
    text += static_cast<char>(value);
  } else if (value < 0x800) {
    text += static_cast<char>(0xC0U | (value >> 6U));
    text += continuation(0);
  } else if (value < 0x10000) {
    text += static_cast<char>(0xE0U | (value >> 12U));
    text += continuation(6);
    text += continuation(0);
  } else {
    text += static_cast<char>(0xF0U | (value >> 18U));
    text += continuation(12);
    text += continuation(6);
    text += continuation(0);
  }
}

void append_repaired(std::string& out, std::string_view text) {
  if (ascii_prefix(text) == text.size()) {
    out += text;
    return;
  }
  while (!text.empty()) {
    std::size_t const valid = valid_utf8_prefix(text);
    out.append(text.substr(0, valid));
    text.remove_prefix(valid);
    if (text.empty()) return;
    append_utf8(out, replacement_character);
    text.remove_prefix(1);
  }
}

std::string repair_utf8(std::string_view text) {
  std::string repaired;
  append_repaired(repaired, text);
  return repaired;
}

}  // namespace axisc
