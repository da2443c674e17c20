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

std::vector<Code> find_codes(std::string_view word) {
  std::vector<Code> found;
  if (!word.ends_with('*')) {
    if (auto const code = find_code(word)) found.push_back(*code);
    return found;
  }
  word.remove_suffix(1);
  std::string const upper = ascii::upper_case(word);
  for (auto const& rule : validator::rules()) {
    if (code_text(rule.code).starts_with(upper) || rule.name.starts_with(word)) found.push_back(rule.code);
  }
  return found;
}

}  // namespace axisc
