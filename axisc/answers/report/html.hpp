// HTML of the report's parts.
#pragma once

#include <string>
#include <string_view>

namespace axisc {

/// "<tag>text</tag>", the text escaped.
[[nodiscard]] std::string text_of(std::string_view tag, std::string_view text);

/// A heading that links lead to.
[[nodiscard]] std::string heading(int level, std::string_view id, std::string_view text);

/// What is folded away until it is wanted; `content` is HTML.
[[nodiscard]] std::string details(std::string_view summary, std::string_view content);

}  // namespace axisc
