#include "axisc/answers/report/printed_height.hpp"

#include "presentation/pictures/text_width.hpp"
#include "presentation/shown_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace axisc {

using namespace presentation;

namespace {

constexpr double cell_padding = 6;   ///< at the right of each cell
constexpr double row_edges = 3.3;    ///< padding and rule of each row
constexpr double table_margin = 16;  ///< above and below together
constexpr double bold = 1.12;
/// What text_width() adds to single letters evens out in words.
constexpr double evened_out = 0.94;
/// Round `code`, instead of its marks.
constexpr double code_padding = 2.4;

double width_of(std::string_view text, PrintedText const& style) {
  double width = pictures::text_width(text, style.size) * evened_out * (style.is_bold ? bold : 1);
  width += static_cast<double>(std::count(text.begin(), text.end(), '`')) * code_padding;
  return width;
}

template <class Take>
void for_each_word(std::string_view text, Take take) {
  while (!text.empty()) {
    auto const end = std::min(text.find(' '), text.size());
    if (end > 0) take(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

double widest_word(std::string_view text, PrintedText const& style) {
  double widest = 0;
  for_each_word(text, [&](std::string_view word) { widest = std::max(widest, width_of(word, style)); });
  return widest;
}

double lines_of(std::string_view text, PrintedText const& style) {
  double const space = width_of(" ", style);
  double lines = 1;
  double at = 0;
  for_each_word(text, [&](std::string_view word) {
    double const width = width_of(word, style);
    if (at > 0 && at + space + width > style.width) {
      ++lines;
      at = 0;
    }
    at += (at > 0 ? space : 0) + width;
    // What has no space is broken, or leaves its column.
    double const further = std::max(0.0, std::ceil(at / style.width) - 1);
    lines += further;
    at -= further * style.width;
  });
  return lines;
}

/// Rows of cells whose first row, or first column, is bold.
struct Cells {
  std::vector<std::vector<std::string>> rows;
  bool has_bold_row = false;

  [[nodiscard]] PrintedText style(PrintedText text, std::size_t row, std::size_t column) const {
    text.is_bold = has_bold_row ? row == 0 : column == 0;
    return text;
  }
};

/// As browsers share the width of a table: each column has its longest word, and of what is left as much as
/// its longest cell asks for.
std::vector<double> column_widths(Cells const& cells, PrintedText const& style) {
  auto const columns = cells.rows.front().size();
  double const whole = style.width - (static_cast<double>(columns) * cell_padding);
  std::vector<double> least(columns);
  std::vector<double> most(columns);
  for (std::size_t row = 0; row < cells.rows.size(); ++row) {
    for (std::size_t i = 0; i < columns; ++i) {
      auto const own = cells.style(style, row, i);
      least[i] = std::max(least[i], widest_word(cells.rows[row][i], own));
      most[i] = std::max(most[i], width_of(cells.rows[row][i], own));
    }
  }
  if (columns > 1) least[1] = std::max(least[1], style.second_column);
  double least_sum = 0;
  double most_sum = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    least_sum += least[i];
    most_sum += most[i];
  }
  if (most_sum <= whole) return most;
  double const share = std::max(0.0, whole - least_sum) / std::max(1.0, most_sum - least_sum);
  for (std::size_t i = 0; i < columns; ++i) least[i] += share * (most[i] - least[i]);
  return least;
}

double height_of(Cells const& cells, PrintedText const& style) {
  if (cells.rows.empty()) return 0;
  auto const widths = column_widths(cells, style);
  double height = 0;
  for (std::size_t row = 0; row < cells.rows.size(); ++row) {
    double lines = 1;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      auto own = cells.style(style, row, i);
      own.width = widths[i] + 0.01;
      lines = std::max(lines, lines_of(cells.rows[row][i], own));
    }
    height += lines * style.line + row_edges;
  }
  return height;
}

}  // namespace

double printed_height(std::string_view text, PrintedText const& style) {
  return lines_of(text, style) * style.line;
}

double printed_height(Table const& table, Language language, PrintedText const& style) {
  if (table.rows.empty()) return 0;
  auto const shown = shown_table(table, language);
  Cells cells{.rows = shown.rows, .has_bold_row = true};
  cells.rows.insert(cells.rows.begin(), shown.headings);
  double const more = shown.more.empty() ? 0 : PrintedText().line + 6;
  return height_of(cells, style) + table_margin + more;
}

double printed_height(Facts const& facts, Language language, PrintedText const& style) {
  Cells cells;
  for (auto const& field : facts.fields) {
    if (!field.value.is_blank()) {
      cells.rows.push_back({text_of(field.label, language), text_of(field.value, language)});
    }
  }
  return height_of(cells, style);
}

}  // namespace axisc
