// The circular test, drawn: deviations of the radius over the angle, magnified, and the causes as bars.
#pragma once

#include "axisc/answers/circle/circular_test.hpp"
#include "presentation/pictures/figure.hpp"

namespace axisc {

/// Both directions of each circle, the prediction dashed beside a recording; two rings show the tolerance
/// about the mean radius.
[[nodiscard]] pictures::Figure circular_figure(CircularTest const& test, Language language);

}  // namespace axisc
