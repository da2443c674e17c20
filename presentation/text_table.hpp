// Cells in aligned columns.
#pragma once

#include "presentation/text_layout.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::presentation {

/// `text` filled with blanks up to `width`.
[[nodiscard]] std::string padded(std::string_view text, std::size_t width);

/// One line per row, columns two blanks apart, each line indented; no blanks at line ends.
[[nodiscard]] std::string text_table(std::span<std::vector<std::string> const> rows, std::size_t indent);

}  // namespace axisc::presentation
