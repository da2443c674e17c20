#include "presentation/shown_table.hpp"

#include <algorithm>

namespace axisc::presentation::says {

constexpr Sentence more_rows{"and {count} more", "und {count} weitere"};

}  // namespace axisc::presentation::says

namespace axisc::presentation {

namespace {

std::string heading_of(Column const& column, Language language) {
  std::string text = text_of(column.label, language);
  auto const unit = symbol(column.unit, language);
  if (unit.empty()) return text;
  return text.append(" [").append(unit).append("]");
}

/// Numbers, with gaps.
bool is_column_of_numbers(Table const& table, std::size_t column) {
  bool any = false;
  for (auto const& row : table.rows) {
    if (row[column].is_nothing()) continue;
    if (!row[column].is_number()) return false;
    any = true;
  }
  return any;
}

}  // namespace

ShownTable shown_table(Table const& table, Language language) {
  ShownTable shown;
  auto const rows = std::min(table.rows.size(), table.most_shown);
  shown.rows.resize(rows);
  if (auto const more = table.rows.size() - rows + table.left_out; more > 0) {
    shown.more = text_of(Words(says::more_rows, {{"count", more}}), language);
  }
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    auto const& column = table.columns[i];
    if (!is_for_people(column.audience)) continue;
    shown.headings.push_back(heading_of(column, language));
    shown.is_right.push_back(is_column_of_numbers(table, i));
    shown.is_head.push_back(column.is_head);
    auto const units = column.unit == Unit::none ? Units::shown : Units::in_heading;
    for (std::size_t row = 0; row < rows; ++row) {
      auto const& value = table.rows[row][i];
      // In a row of many an empty place reads better than a dash.
      shown.rows[row].push_back(value.is_blank() ? std::string() : text_of(value, language, units));
    }
  }
  return shown;
}

}  // namespace axisc::presentation
