// UTF-8, read strictly: no overlong forms, no surrogates, nothing above U+10FFFF.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace axisc {

/// U+FFFD, shown for bytes that cannot be decoded.
inline constexpr char32_t replacement_character = 0xFFFD;

/// What Windows writes in front of UTF-8.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
[[nodiscard]] constexpr std::string_view without_byte_order_mark(std::string_view text) {
  return text.substr(text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
}

/// Bytes from the front of `text` that are ASCII, except that up to seven may be missed before the first
/// other byte. Cost: linear, many bytes at a time.
[[nodiscard]] std::size_t ascii_prefix(std::string_view text);

/// Bytes from the front of `text` that are well-formed UTF-8; text.size() when all of them are.
/// Cost: linear, many ASCII bytes at a time.
[[nodiscard]] std::size_t valid_utf8_prefix(std::string_view text);

struct DecodedCharacter {
  char32_t value = 0;    ///< replacement_character where the bytes are not well-formed
  std::size_t size = 0;  ///< bytes it takes, 1 where they are not well-formed; 0 only at the end of the text
};

/// The character at the front of `text`.
[[nodiscard]] DecodedCharacter decode_utf8(std::string_view text);

/// Appends a code point; surrogates and numbers above U+10FFFF become the replacement character.
void append_utf8(std::string& text, char32_t character);

/// `text` with every byte that is not part of a well-formed character replaced by U+FFFD.
[[nodiscard]] std::string repair_utf8(std::string_view text);
/// Appends `text`, with every byte that is not part of a well-formed character replaced by U+FFFD, to `out`.
void append_repaired(std::string& out, std::string_view text);

/// True for a byte that does not begin a character.
[[nodiscard]] constexpr bool is_continuation_byte(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// The number of continuation bytes. Cost: eight bytes at a time.
[[nodiscard]] std::size_t count_continuation_bytes(std::string_view text);

}  // namespace axisc
