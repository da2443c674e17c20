#include "axisc/answers/report/cover_space.hpp"

#include <algorithm>

namespace axisc {

using namespace presentation;

namespace {

/// No page has room for more, and looking at them would take time.
void cut(Table& table) {
  constexpr std::size_t most_rows = 60;
  if (table.rows.size() <= most_rows) return;
  table.left_out += table.rows.size() - most_rows;
  table.rows.resize(most_rows);
}

}  // namespace

double printed_paragraph(std::string_view words, PrintedText const& style) {
  constexpr double margin = 6;
  return printed_height(words, style) + margin;
}

double paragraphs_height(ReportBlocks const& blocks, Language language) {
  double height = 0;
  for (auto const& block : blocks) {
    if (auto const* const one = std::get_if<Paragraph>(&block)) {
      height += printed_paragraph(text_of(one->words, language));
    }
  }
  return height;
}

void add_tables(std::vector<CoverTable>& tables, ReportBlocks& blocks) {
  for (auto& block : blocks) {
    if (auto* const table = std::get_if<Table>(&block)) tables.push_back({.table = table});
  }
}

bool fit_tables(std::vector<CoverTable>& tables, double room, Language language) {
  std::vector<double> heights;
  double all = 0;
  for (auto const& [table, least, style] : tables) {
    cut(*table);
    table->most_shown = std::min(least, table->rows.size());
    all += heights.emplace_back(printed_height(*table, language, style));
  }
  bool const fits = all <= room;
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      auto& table = *tables[i].table;
      if (table.most_shown >= table.rows.size()) continue;
      ++table.most_shown;
      double const height = printed_height(table, language, tables[i].style);
      if (all - heights[i] + height > room) {
        --table.most_shown;
        continue;
      }
      all += height - heights[i];
      heights[i] = height;
      grows = true;
    }
  }
  return fits;
}

bool is_whole(Table const& table) {
  return table.most_shown >= table.rows.size() && table.left_out == 0;
}

}  // namespace axisc
