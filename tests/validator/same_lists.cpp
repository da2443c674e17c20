#include "validator/same_lists.hpp"

#include "validator/values/line_values.hpp"
#include "validator/values/list_reader.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace axisc::tests {
namespace {

using validator::LineValue;
using validator::LineValues;

bool same_readings(LineValue const& a, LineValue const& b) {
  return a.row == b.row &&
         std::bit_cast<std::uint64_t>(a.value.number) == std::bit_cast<std::uint64_t>(b.value.number) &&
         a.value.text == b.value.text && a.reference.p_axis == b.reference.p_axis &&
         a.reference.index == b.reference.index && a.text == b.text && a.trouble == b.trouble &&
         a.slot == b.slot && a.name_status == b.name_status && a.status == b.status && a.number == b.number &&
         a.name_folded == b.name_folded && a.symbol_folded == b.symbol_folded && a.quoted == b.quoted;
}

template <typename Range>
bool same_ranges(Range const& a, Range const& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

bool same_readings(LineValues const& a, LineValues const& b, schema::Catalogue const& catalogue) {
  if (a.size() != b.size() || a.has_repetitions() != b.has_repetitions() ||
      a.may_name_numbers() != b.may_name_numbers() || !same_ranges(a.doubtful(), b.doubtful()) ||
      !same_ranges(a.without_value(), b.without_value())) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a.slot(i) != b.slot(i) || !same_readings(a[i], b[i]) ||
        a.suggestions(i).names != b.suggestions(i).names) {
      return false;
    }
  }
  for (std::size_t i = 0; i < catalogue.slot_count(); ++i) {
    if (a.last_of(static_cast<schema::Slot>(i)) != b.last_of(static_cast<schema::Slot>(i))) return false;
  }
  return true;
}

}  // namespace

bool same_lists(validator::ReadList const& a, validator::ReadList const& b,
                schema::Catalogue const& catalogue) {
  return a.tree == b.tree && same_readings(a.line_values, b.line_values, catalogue);
}

bool reads_as_by_the_grammar(SourceText const& source, schema::Catalogue const& catalogue) {
  bool const is_windows = source.encoding() == Encoding::windows_1252;
  auto tree = grammar::parse_axis_list(source.bytes(), source.text_begin(), is_windows);
  return tree == grammar::parse_axis_list(source) &&
         same_lists(validator::read_list(source, catalogue),
                    validator::judge_list(source, std::move(tree), catalogue), catalogue);
}

}  // namespace axisc::tests
