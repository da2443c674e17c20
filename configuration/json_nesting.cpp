#include "configuration/json_nesting.hpp"

#include <algorithm>

namespace axisc::configuration {

std::size_t json_nesting(std::string_view json) {
  std::size_t open = 0;
  std::size_t most = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    char const each = json[i];
    if (in_text) {
      if (each == '\\') ++i;
      in_text = each != '"';
    } else if (each == '"') {
      in_text = true;
    } else if (each == '[' || each == '{') {
      most = std::max(most, ++open);
    } else if (open > 0 && (each == ']' || each == '}')) {
      --open;
    }
  }
  return most;
}

}  // namespace axisc::configuration
