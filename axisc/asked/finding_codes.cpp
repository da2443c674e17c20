#include "axisc/asked/finding_codes.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/engine/rule.hpp"

#include <string>

namespace axisc {

std::optional<Code> find_code(std::string_view word) {
  std::string const upper = ascii::upper_case(word);
  for (auto const& rule : validator::rules()) {
    if (code_text(rule.code) == upper || rule.name == word) return rule.code;
  }
  return std::nullopt;
}

}  // namespace axisc
