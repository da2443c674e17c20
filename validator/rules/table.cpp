// The table of all rules.
#include "validator/rule.hpp"
#include "validator/rules/filter_checks.hpp"

#include <algorithm>
#include <vector>

namespace axisc::validator {
namespace {

std::vector<Rule> rows() {
  std::vector<Rule> table = {
#include "validator/rules/filter_rows.inc"
  };
  std::sort(table.begin(), table.end(), [](Rule const& a, Rule const& b) { return a.code < b.code; });
  return table;
}

}  // namespace

std::span<Rule const> rules() {
  static std::vector<Rule> const table = rows();
  return table;
}

Rule const* find_rule(Code wanted) {
  std::span<Rule const> const table = rules();
  auto const row = std::lower_bound(table.begin(), table.end(), wanted,
                                    [](Rule const& rule, Code value) { return rule.code < value; });
  return row != table.end() && row->code == wanted ? &*row : nullptr;
}

}  // namespace axisc::validator
