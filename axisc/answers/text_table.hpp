// Cells in aligned columns.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// Columns a terminal needs for UTF-8 text without combining characters.
[[nodiscard]] std::size_t display_width(std::string_view text);

/// `text` filled with blanks up to `width`.
[[nodiscard]] std::string padded(std::string_view text, std::size_t width);

/// One line per row, columns two blanks apart, each line indented; no blanks at line ends.
[[nodiscard]] std::string text_table(std::span<std::vector<std::string> const> rows, std::size_t indent);

}  // namespace axisc
