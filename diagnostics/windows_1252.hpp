// windows-1252, the single-byte encoding of the lists that are not UTF-8.
#pragma once

#include <optional>

namespace axisc {

/// The character of a byte; U+FFFD for 0x81, 0x8D, 0x8F, 0x90 and 0x9D, which have none.
[[nodiscard]] char32_t decode_windows_1252(char byte);

/// The byte of a character; none for a character that windows-1252 lacks.
[[nodiscard]] std::optional<char> encode_windows_1252(char32_t character);

}  // namespace axisc
