#include "cli/output/decimal_comma.hpp"

#include "cli/output/printed_errors.hpp"

#include <algorithm>

namespace axisc::cli::says {

constexpr Sentence two_values{
    R"({option} "{list}" is two values, {first} and {second}; a decimal point is written ".")",
    R"({option} "{list}" sind zwei Werte, {first} und {second}; vor Dezimalstellen steht ".")"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void remark_decimal_comma(Invocation const& invocation, std::string const& option,
                          std::optional<std::string> const& list) {
  if (!list) return;
  constexpr auto digits = "0123456789";
  auto const comma = list->find(',');
  if (comma == 0 || comma == std::string::npos || list->find_first_not_of(digits) != comma) return;
  auto const second = list->substr(comma + 1);
  auto const end = std::min(second.find_first_not_of(digits), second.size());
  bool const is_fraction = (end == 1 || end == 2) && second[end - 1] != '0' && second[end] != '.';
  if (!is_fraction || second.find(',') != std::string::npos) return;
  printed_remarks(invocation)(
      {says::two_values,
       {{"option", option}, {"list", *list}, {"first", list->substr(0, comma)}, {"second", second}}});
}

}  // namespace axisc::cli
