// Figures in a terminal, drawn with the dots of braille letters.
#pragma once

#include "diagnostics/sentence.hpp"
#include "presentation/pictures/figure.hpp"

#include <cstddef>
#include <string>

namespace axisc::pictures {

/// Lines of at most `columns` letters, 40 or more: the title, each panel with the ends of its axes, the
/// legend of several curves and the marks. Curves cannot be told apart; the table has their values.
[[nodiscard]] std::string braille(Figure const& figure, std::size_t columns, Language language);

}  // namespace axisc::pictures
