// A picture of the suggestions: gain over frequency with the resonances marked, and the answer to a step.
#pragma once

#include "axisc/answers/suggestion/suggested.hpp"
#include "diagnostics/message.hpp"
#include "presentation/pictures/figure.hpp"

namespace axisc {

/// The present setting is dashed. Failure where no filters are suggested.
[[nodiscard]] pictures::Figure suggest_figure(Suggested const& suggested, Language language);

}  // namespace axisc
