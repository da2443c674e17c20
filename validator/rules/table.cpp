// The table of all rules.
#include "validator/rule.hpp"
#include "validator/rules/checks.hpp"
#include "validator/rules/filter_checks.hpp"
#include "validator/rules/kernel_checks.hpp"
#include "validator/rules/machine_checks.hpp"
#include "validator/rules/position_control_checks.hpp"
#include "validator/rules/program_checks.hpp"

#include <algorithm>
#include <array>
#include <variant>

namespace axisc::validator {
namespace {

/// Ready when the program starts.
constexpr auto table = [] {
  auto rows = std::to_array<Rule>({
      // clang-format off
      {.code = Code{1001}, .name = "invalid-character", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::invalid_character}},
      {.code = Code{1002}, .name = "expected-name", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::expected_name}},
      {.code = Code{1003}, .name = "expected-value", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::expected_value}},
      {.code = Code{1004}, .name = "malformed-index", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::malformed_index}},
      {.code = Code{1005}, .name = "decimal-comma", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::decimal_comma}},
      {.code = Code{1006}, .name = "malformed-number", .severity = Severity::error, .control = "1001138",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::malformed_number}},
      {.code = Code{1007}, .name = "suspicious-trailer", .severity = Severity::warning, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::suspicious_trailer}},
      {.code = Code{1008}, .name = "text-after-end", .severity = Severity::warning, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::text_after_end}},
      {.code = Code{1009}, .name = "comment-in-string", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::comment_in_string}},
      {.code = Code{1010}, .name = "letter-case", .severity = Severity::warning, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::letter_case}},
      {.code = Code{1011}, .name = "comment-names-other-parameter", .severity = Severity::warning, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::comment_names_other_parameter}},
      {.code = Code{1012}, .name = "unterminated-string", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::unterminated_string}},
      {.code = Code{1013}, .name = "unused-suppression", .severity = Severity::warning, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{2001}, .name = "unknown-parameter", .severity = Severity::warning, .control = "1001119",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::unknown_parameter}},
      {.code = Code{2002}, .name = "index-out-of-range", .severity = Severity::error, .control = "2009",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::index_out_of_range}},
      {.code = Code{2003}, .name = "wrong-type", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::wrong_type}},
      {.code = Code{2004}, .name = "out-of-data-range", .severity = Severity::error, .control = "1001138",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::out_of_data_range}},
      {.code = Code{2005}, .name = "out-of-range", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::out_of_range}},
      {.code = Code{2006}, .name = "duplicate-parameter", .severity = Severity::warning, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::duplicate_parameter}},
      {.code = Code{2007}, .name = "unknown-symbol", .severity = Severity::error, .control = "2022",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::unknown_symbol}},
      {.code = Code{2008}, .name = "string-too-long", .severity = Severity::error, .control = "2023",
       .needs = Needs::nothing, .silenced_by = {}, .check = ListCheck{checks::string_too_long}},
      {.code = Code{2009}, .name = "axis-type-mismatch", .severity = Severity::warning, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::axis_type_mismatch}},
      {.code = Code{2010}, .name = "reference-unresolvable", .severity = Severity::error, .control = "2052",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::reference_unresolvable}},
      {.code = Code{2011}, .name = "reference-circular", .severity = Severity::error, .control = "2051",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::reference_circular}},
      {.code = Code{2012}, .name = "reference-type", .severity = Severity::error, .control = "2062",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::reference_type}},
      {.code = Code{2013}, .name = "reference-index", .severity = Severity::error, .control = "2045",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::reference_index}},
      {.code = Code{2014}, .name = "reference-unit", .severity = Severity::warning, .control = "2049",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::reference_unit}},
      {.code = Code{2015}, .name = "limit-by-parameter", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::limit_by_parameter}},
      {.code = Code{2016}, .name = "newer-than-build", .severity = Severity::warning, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = AxisCheck{checks::newer_than_build},
       .program_check = checks::commands_newer_than_build},
      {.code = Code{4020}, .name = "machine-file", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{9001}, .name = "cannot-read", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{9002}, .name = "cannot-write", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{9003}, .name = "too-large", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{9004}, .name = "not-an-image", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{9005}, .name = "csv-malformed", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{9006}, .name = "cycle-time-assumed", .severity = Severity::note, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{9007}, .name = "not-simulated", .severity = Severity::warning, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{9008}, .name = "cannot-simulate", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
      {.code = Code{9009}, .name = "plant-file", .severity = Severity::error, .control = "",
       .needs = Needs::nothing, .silenced_by = {}, .check = std::monostate{}},
  // clang-format on
#include "validator/rules/filter_rows.inc"
#include "validator/rules/kernel_rows.inc"
#include "validator/rules/machine_rows.inc"
#include "validator/rules/position_control_rows.inc"
#include "validator/rules/program_rows.inc"
  });
  std::sort(rows.begin(), rows.end(), [](Rule const& a, Rule const& b) { return a.code < b.code; });
  return rows;
}();

constexpr std::size_t possible_codes = 10000;
constexpr std::uint8_t no_rule = 255;
static_assert(table.size() < no_rule);

/// The number of a code's rule in the table.
constexpr auto number_of_code = [] {
  std::array<std::uint8_t, possible_codes> numbers{};
  numbers.fill(no_rule);
  for (std::size_t i = 0; i < table.size(); ++i) {
    numbers[static_cast<std::size_t>(table[i].code)] = static_cast<std::uint8_t>(i);
  }
  return numbers;
}();

template <typename... Checks>
constexpr bool has_check_of(Rule const& rule) {
  return (std::holds_alternative<Checks>(rule.check) || ...);
}

template <typename... Checks>
constexpr auto selected = [] {
  constexpr auto count = std::count_if(table.begin(), table.end(), has_check_of<Checks...>);
  std::array<Rule const*, static_cast<std::size_t>(count)> rows{};
  auto* next = rows.begin();
  for (Rule const& rule : table) {
    if (has_check_of<Checks...>(rule)) *next++ = &rule;
  }
  return rows;
}();

}  // namespace

std::span<Rule const> rules() {
  return table;
}

template <>
std::span<Rule const* const> rules_with<ListCheck>() {
  return selected<ListCheck>;
}

template <>
std::span<Rule const* const> rules_with<AxisCheck, FilterCheck>() {
  return selected<AxisCheck, FilterCheck>;
}

template <>
std::span<Rule const* const> rules_with<MachineCheck, GroupCheck>() {
  return selected<MachineCheck, GroupCheck>;
}

Rule const* find_rule(Code code) {
  auto const index = static_cast<std::size_t>(code);
  std::uint8_t const number = index < possible_codes ? number_of_code[index] : no_rule;
  return number == no_rule ? nullptr : &table[number];
}

}  // namespace axisc::validator
