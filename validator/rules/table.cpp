// The table of all rules, from the folders next to this file.
#include "rule_folders.hpp"
#include "validator/engine/rule.hpp"
#include "validator/engine/rule_facts.hpp"
#include "validator/engine/rule_title.hpp"
#include "validator/rules/page_table.hpp"

#include <array>
#include <cstdint>

namespace axisc::validator {
namespace {

constexpr std::size_t possible_codes = 10000;
constexpr std::uint8_t no_rule = 255;
static_assert(rule_folders.size() < no_rule);

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

std::span<Rule const> rules() {
  static auto const table = [] {
    std::array<Rule, rule_folders.size()> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i] = *rule_folders[i].row;
      rows[i].code = rule_folders[i].code;
      rows[i].name = rule_folders[i].name;
    }
    return rows;
  }();
  return table;
}

Rule const* find_rule(Code code) {
  auto const index = static_cast<std::size_t>(code);
  std::uint8_t const number = index < possible_codes ? number_of_code[index] : no_rule;
  return number == no_rule ? nullptr : &rules()[number];
}

std::size_t number_of(Rule const& rule) {
  return static_cast<std::size_t>(&rule - rules().data());
}

Page const& page(Rule const& rule) {
  return page_table()[number_of(rule)];
}

RuleFacts const& facts(Rule const& rule) {
  return facts_table()[number_of(rule)];
}

Page const& title(Rule const& rule) {
  return page_title_table()[number_of(rule)];
}

}  // namespace axisc::validator
