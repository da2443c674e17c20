// The table of all rules, from the folders next to this file.
#include "rule_folders.hpp"
#include "validator/engine/rule.hpp"
#include "validator/rules/page_table.hpp"

#include <array>
#include <cstdint>

namespace axisc::validator {
namespace {

/// Ready when the program starts.
constexpr auto table = [] {
  std::array<Rule const*, rule_folders.size()> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = rule_folders[i].row;
  return rows;
}();

constexpr std::size_t possible_codes = 10000;
constexpr std::uint8_t no_rule = 255;
static_assert(table.size() < no_rule);

/// The index of a code's rule in the table.
constexpr auto number_of_code = [] {
  std::array<std::uint8_t, possible_codes> numbers{};
  numbers.fill(no_rule);
  for (std::size_t i = 0; i < rule_folders.size(); ++i) {
    numbers[static_cast<std::size_t>(rule_folders[i].code)] = static_cast<std::uint8_t>(i);
  }
  return numbers;
}();

}  // namespace

RuleRange rules() {
  return {table, RuleRange::all_kinds};
}

Rule const* find_rule(Code code) {
  auto const index = static_cast<std::size_t>(code);
  std::uint8_t const number = index < possible_codes ? number_of_code[index] : no_rule;
  return number == no_rule ? nullptr : table[number];
}

std::size_t number_of(Rule const& rule) {
  return number_of_code[static_cast<std::size_t>(rule.code)];
}

Page const& page(Rule const& rule) {
  return page_table()[number_of(rule)];
}

}  // namespace axisc::validator
