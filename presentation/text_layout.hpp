// Plain text in columns of a terminal: widths, wrapped paragraphs, tables.
#pragma once

#include "presentation/shown_table.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace axisc::presentation {

/// Columns that a text takes: its code points.
[[nodiscard]] std::size_t display_width(std::string_view text);

/// The words in lines of at most `width` columns, each ended; all but the first begin with `indent` blanks. A
/// longer word has its own line, and a number stays with the word behind it: its unit.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0);

/// The words in lines that begin at `column`, where the first already is, without a line end.
[[nodiscard]] std::string hanging(std::string_view text, std::size_t width, std::size_t column);

/// The table's lines. Where they would be wider than `width`, headings and a last column of text are wrapped;
/// where that does not help, columns are put below each other in groups, each with the head columns, which
/// are not divided.
[[nodiscard]] std::string table_text(ShownTable const& table, std::size_t width);

}  // namespace axisc::presentation
