// The cover is one page of paper, whatever the machine: its tables show as many rows as fit.
#pragma once

#include "axisc/answers/report/printed_height.hpp"
#include "axisc/answers/report/report_page.hpp"

#include <cstddef>
#include <vector>

namespace axisc {

/// A table on the cover, whose first rows are shown.
struct CoverTable {
  presentation::Table* table = nullptr;
  std::size_t least = 3;  ///< rows, whether they fit or not
  PrintedText style = {.size = 8.5, .line = 11.5};
};

/// In points: what the page has, and what a heading takes.
inline constexpr double cover_height = 740;
inline constexpr double cover_heading = 33;

[[nodiscard]] double printed_paragraph(std::string_view words, PrintedText const& style = {});

/// Of everything but tables.
[[nodiscard]] double paragraphs_height(ReportBlocks const& blocks, Language language);

/// The tables among the blocks, to be shortened.
void add_tables(std::vector<CoverTable>& tables, ReportBlocks& blocks);

/// Shows the least of each table, then in turn one row more, as long as all of them fit into `room`. False
/// where not even the least does.
bool fit_tables(std::vector<CoverTable>& tables, double room, Language language);

[[nodiscard]] bool is_whole(presentation::Table const& table);

}  // namespace axisc
