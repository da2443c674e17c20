#include "presentation/shown_table.hpp"

#include <algorithm>

namespace axisc::presentation::says {

constexpr Sentence more_rows{"and {count} more", "und {count} weitere"};

}  // namespace axisc::presentation::says

namespace axisc::presentation {

namespace {

std::string heading_of(Column const& column, Unit unit, Language language, ForeignText foreign) {
  std::string text = text_of(column.label, language, foreign);
  auto const shown = symbol(unit, language);
  if (shown.empty()) return text;
  return text.append(" [").append(shown).append("]");
}

/// The one unit of all numbers of a column; the heading shows it.
Unit unit_of(Table const& table, std::size_t column) {
  auto unit = table.columns[column].unit;
  for (auto const& row : table.rows) {
    auto const& form = row[column].form();
    auto const* const quantity = std::get_if<Quantity>(&form);
    auto const* const numbers = std::get_if<Numbers>(&form);
    if (quantity == nullptr && numbers == nullptr) continue;
    auto const own = quantity != nullptr ? quantity->unit : numbers->unit;
    if (unit == Unit::none) unit = own;
    if (own != Unit::none && own != unit) return Unit::none;
  }
  return unit;
}

/// Nobody reads an empty column.
bool has_cells(Table const& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [&](std::vector<Value> const& row) { return !row[column].is_blank(); });
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

ShownTable shown_table(Table const& table, Language language, ForeignText foreign) {
  ShownTable shown;
  auto const rows = std::min(table.rows.size(), table.most_shown);
  shown.rows.resize(rows);
  if (auto const more = table.rows.size() - rows + table.left_out; more > 0) {
    shown.more = text_of(Words(says::more_rows, {{"count", more}}), language);
  }
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    auto const& column = table.columns[i];
    if (!is_for_people(column.audience) || !has_cells(table, i)) continue;
    auto const unit = unit_of(table, i);
    shown.columns.push_back(i);
    shown.headings.push_back(heading_of(column, unit, language, foreign));
    shown.is_right.push_back(is_column_of_numbers(table, i));
    shown.is_head.push_back(column.is_head);
    auto const place_of_unit = unit == Unit::none ? Units::shown : Units::in_heading;
    for (std::size_t row = 0; row < rows; ++row) {
      auto const& value = table.rows[row][i];
      // In a row of many an empty place reads better than a dash.
      shown.rows[row].push_back(value.is_blank() ? std::string()
                                                 : text_of(value, language, place_of_unit, foreign));
    }
  }
  return shown;
}

}  // namespace axisc::presentation
