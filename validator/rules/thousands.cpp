#include "validator/rules/thousands.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/sentences.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace axisc::validator {
namespace {

/// `500.000` or `1.500.000`: either a decimal point, or points between thousands as in German.
bool has_thousands_points(std::string_view value) {
  constexpr std::size_t group = 3;
  if (value.starts_with('-') || value.starts_with('+')) value.remove_prefix(1);
  auto const all_digits = [](std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), ascii::is_digit);
  };
  std::size_t const point = value.find('.');
  if (point > group || !all_digits(value.substr(0, point))) return false;
  for (value.remove_prefix(point); !value.empty(); value.remove_prefix(group + 1)) {
    if (value.size() <= group || value.front() != '.' || !all_digits(value.substr(1, group))) return false;
  }
  return true;
}

}  // namespace

bool describe_thousands(Finding& finding, std::string const& value) {
  if (!has_thousands_points(value)) return false;
  std::string digits = value;
  std::erase(digits, '.');
  bool const is_one_point = digits.size() + 1 == value.size();
  finding.help.push_back(message_of(says::parameter_did_you_mean, Argument{"suggestion", std::move(digits)}));
  if (is_one_point) {
    finding.help.push_back(
        message_of(says::parameter_did_you_mean, Argument{"suggestion", value.substr(0, value.find('.'))}));
  }
  return true;
}

}  // namespace axisc::validator
