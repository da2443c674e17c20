// Figures as SVG: text, the same bytes on every host, no scripts. Colours follow the reader's light or dark
// scheme, line styles tell curves apart in print.
#pragma once

#include "diagnostics/sentence.hpp"
#include "presentation/pictures/figure.hpp"

#include <string>

namespace axisc::pictures {

/// The whole file. Values that are not finite interrupt a curve; those outside a panel are drawn at its edge.
[[nodiscard]] std::string svg(Figure const& figure, Language language);

}  // namespace axisc::pictures
