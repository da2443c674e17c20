#include "grammar/plain_scanner.hpp"
#include "lists/readers.hpp"

#include <charconv>

namespace axisc::bench {
namespace {

using grammar::ValueKind;

/// None for what does not fit.
bool convert(std::string_view token, ValueKind kind, schema::Parameter const& parameter, double& number) {
  bool const negative = token.front() == '-';
  if (negative || token.front() == '+') token.remove_prefix(1);
  if (kind == ValueKind::real) {
    if (schema::is_integer(parameter.type)) return false;
    std::from_chars(token.data(), token.data() + token.size(), number);
  } else {
    std::uint64_t magnitude = 0;
    bool const hexadecimal = kind == ValueKind::hexadecimal;
    if (hexadecimal) token.remove_prefix(2);
    auto const result =
        std::from_chars(token.data(), token.data() + token.size(), magnitude, hexadecimal ? 16 : 10);
    if (result.ec != std::errc{}) return false;
    number = static_cast<double>(magnitude);
  }
  if (negative) number = -number;
  return true;
}

}  // namespace

void read_by_hand(std::string_view list, EntryTable& table) {
  table.clear();
  grammar::AxisList const tree = test::scan_axis_list(list, false);
  for (grammar::Assignment const& assignment : tree.assignments) {
    schema::Parameter const* const parameter =
        table.open(list.substr(assignment.name.begin, assignment.name.size()), assignment.value.begin);
    if (parameter == nullptr) continue;
    std::string_view const token = list.substr(assignment.value.begin, assignment.value.size());
    switch (assignment.kind) {
      case ValueKind::integer:
      case ValueKind::hexadecimal:
      case ValueKind::real: {
        double number = 0;
        if (convert(token, assignment.kind, *parameter, number)) {
          table.number(*parameter, number);
        } else {
          table.wrong_type();
        }
        break;
      }
      case ValueKind::word: table.word(*parameter, token); break;
      default:
        if (assignment.kind != ValueKind::reference) table.wrong_type();
    }
  }
}

}  // namespace axisc::bench
