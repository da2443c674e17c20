// The encodings of recordings: UTF-8, UTF-16 with a byte order mark, else windows-1252.
#pragma once

#include "analysis/recordings/text_lines.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace axisc::recordings {

/// The source's bytes; those of UTF-16 (either byte order, with its mark) as UTF-8. What is not well-formed
/// becomes U+FFFD.
[[nodiscard]] ByteSource as_utf8(ByteSource source);

/// The first `count` bytes, fewer where the source ends; it hands them out again.
[[nodiscard]] std::string first_bytes(ByteSource& source, std::size_t count);

/// Text that is not well-formed UTF-8 is windows-1252.
[[nodiscard]] std::string utf8_text(std::string_view bytes);

/// For messages: the beginning of a field.
[[nodiscard]] std::string shown_text(std::string_view field);

}  // namespace axisc::recordings
