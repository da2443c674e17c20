// Characters that look like others: text copied from a manual contains them instead of blanks, signs and
// letters.
#pragma once

#include <string_view>

namespace axisc {

struct UnusualCharacter {
  char32_t code = 0;
  std::string_view name;     ///< of Unicode
  std::string_view instead;  ///< what it looks like, in ASCII; empty for one that is not visible
};

/// Null for every other character. Cost: a binary search.
[[nodiscard]] UnusualCharacter const* find_unusual(char32_t character);

}  // namespace axisc
