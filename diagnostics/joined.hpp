// Words in a row.
#pragma once

#include <string>
#include <string_view>

namespace axisc {

/// "X, Y, Z".
template <typename Range>
[[nodiscard]] std::string joined(Range const& words, std::string_view separator = ", ") {
  std::string text;
  for (auto const& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

}  // namespace axisc
