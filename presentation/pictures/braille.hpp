// Figures in a terminal, drawn with the dots of braille letters.
#pragma once

#include "diagnostics/sentence.hpp"
#include "presentation/pictures/figure.hpp"

#include <cstddef>
#include <string>

namespace axisc::pictures {

/// Lines of at most `columns` letters, 40 or more: the title, each panel with the ends of its axes, the legend of several curves
/// and the marks. Which curve is which is not seen; the table says what they are.
[[nodiscard]] std::string braille(Figure const& figure, std::size_t columns, Language language);

}  // namespace axisc::pictures
