// Where an axis has its labels, and how they are written.
#pragma once

#include "diagnostics/sentence.hpp"
#include "presentation/pictures/figure.hpp"

#include <string>
#include <vector>

namespace axisc::pictures {

/// Round numbers from low to high, rising: on a linear scale multiples of 1, 2 or 5 times a power of ten,
/// about `wanted` of them; on a logarithmic one powers of ten, and 2 and 5 times these where there is room.
/// Those of the axis itself where it names some.
[[nodiscard]] std::vector<double> ticks_of(Axis const& axis, std::size_t wanted);

/// 1, 2 or 5 times a power of ten, not above `value`.
[[nodiscard]] double round_below(double value);

/// A number as readers of the language write it: "-0.5", "20 000"; German "-0,5". At most six significant
/// digits.
[[nodiscard]] std::string number_text(double value, Language language);

}  // namespace axisc::pictures
