// Letter case without the C locale.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace axisc::schema {

constexpr char lower_case(char byte) {
  return byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : byte;
}

/// Only A to Z change.
inline std::string lower_case(std::string_view text) {
  std::string folded(text);
  std::transform(folded.begin(), folded.end(), folded.begin(), [](char byte) { return lower_case(byte); });
  return folded;
}

}  // namespace axisc::schema
