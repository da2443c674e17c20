// Characters that no line of a list may contain, not even a comment.
#pragma once

#include "diagnostics/span.hpp"

#include <optional>
#include <string_view>

namespace axisc::grammar {

/// The first one in `line`, as offsets into it: a control character other than the tab (a CR inside a line is
/// one), in UTF-8 also U+0080 to U+009F, in windows-1252 one of the five bytes without a character (81,
/// 8D, 8F, 90, 9D hex). Cost: one pass, eight bytes at a time where they are plain text.
[[nodiscard]] std::optional<Span> find_invalid_character(std::string_view line, bool windows_1252);

}  // namespace axisc::grammar
