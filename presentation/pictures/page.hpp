// Figures on pages: the picture and its numbers, readable without a network and without scripts. With scripts
// the pictures zoom, by uPlot, which the page contains.
#pragma once

#include "diagnostics/sentence.hpp"
#include "presentation/pictures/figure.hpp"

#include <string>

namespace axisc::pictures {

/// A complete HTML document.
[[nodiscard]] std::string page(Figure const& figure, Language language);

/// The picture and its table, for a part of a page.
[[nodiscard]] std::string figure_element(Figure const& figure, Language language);

/// A table with a header row; cells in columns of numbers are right-aligned.
[[nodiscard]] std::string table_element(Table const& table);

/// Colours, print, tables and zoom of pages with figures.
[[nodiscard]] std::string page_style();

/// The end of a page's body: the script that zooms, and its licence.
[[nodiscard]] std::string zoom_part(Language language);

/// The script of that part, from tag to tag. It depends on nothing but the language.
[[nodiscard]] std::string page_script(Language language);

}  // namespace axisc::pictures
