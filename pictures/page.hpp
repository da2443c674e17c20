// A figure as a page of its own: the picture and its numbers, readable without a network and without scripts.
#pragma once

#include "diagnostics/sentence.hpp"
#include "pictures/figure.hpp"

#include <string>

namespace axisc::pictures {

/// A complete HTML document.
[[nodiscard]] std::string page(Figure const& figure, Language language);

/// The picture and its table, for a part of a page.
[[nodiscard]] std::string figure_element(Figure const& figure, Language language);

/// A table with a header row; of columns of numbers the cells stand right.
[[nodiscard]] std::string table_element(Table const& table);

/// Colours, print and tables of pages with figures.
[[nodiscard]] std::string_view page_style();

}  // namespace axisc::pictures
