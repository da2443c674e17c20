// What suggest_names() promises, worked out the long way: every name compared with every other, letter by
// letter.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axisc::test {

struct PlainSuggestions {
  std::vector<std::string> names;
  bool certain = false;
};
[[nodiscard]] PlainSuggestions suggest_names_plainly(std::string_view name);

}  // namespace axisc::test
