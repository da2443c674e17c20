#include "cli/schema_words.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/value.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <system_error>

namespace axisc::cli {

namespace {

using schema::DataType;

bool is_lower_case_name(std::string_view part) {
  if (part.ends_with("[]")) part.remove_suffix(2);
  auto const is_letter = [](char c) { return ascii::is_small(c) || c == '_'; };
  return !part.empty() && is_letter(part.front()) &&
         std::all_of(part.begin(), part.end(), [&](char c) { return is_letter(c) || ascii::is_digit(c); });
}

}  // namespace

std::optional<DataType> parse_data_type(std::string_view word) {
  for (auto const& row : schema::data_types) {
    if (row.name == word) return row.type;
  }
  return std::nullopt;
}

std::string data_type_names() {
  std::string names;
  for (auto const& row : schema::data_types) names.append(names.empty() ? "" : ", ").append(row.name);
  return names;
}

bool is_parameter_pattern(std::string_view name) {
  if (std::count(name.begin(), name.end(), '[') > 2) return false;
  while (true) {
    std::size_t const dot = std::min(name.find('.'), name.size());
    if (!is_lower_case_name(name.substr(0, dot))) return false;
    if (dot == name.size()) return true;
    name.remove_prefix(dot + 1);
  }
}

std::optional<std::uint16_t> parse_p_axis(std::string_view text) {
  constexpr std::string_view prefix = "P-AXIS-";
  constexpr std::size_t digits = 5;
  if (!text.starts_with(prefix) || text.size() != prefix.size() + digits) return std::nullopt;
  std::uint16_t number = 0;
  auto const [end, error] = std::from_chars(text.data() + prefix.size(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number == 0) return std::nullopt;
  return number;
}

bool is_default_of(schema::ParameterRow const& row, std::string const& text) {
  bool const is_symbol = std::any_of(row.symbols.begin(), row.symbols.end(),
                                     [&text](auto const& symbol) { return symbol.first == text; });
  if (is_symbol) return true;
  auto const is_good = [](validator::NumberReading const& reading) {
    return reading.status == validator::NumberStatus::good;
  };
  switch (row.type) {
    case DataType::boolean:
      return text == "0" || text == "1";
    case DataType::string:
      // A set of flags has "none" as its default, which is a number and no word.
      return row.symbols.empty() || is_good(validator::read_integer(text, DataType::uns64));
    case DataType::real64:
      return is_good(validator::read_real(text));
    default:
      return is_good(validator::read_integer(text, row.type));
  }
}

}  // namespace axisc::cli
