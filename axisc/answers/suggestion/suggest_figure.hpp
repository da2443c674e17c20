// A picture of the suggestions: gain over frequency with the resonances marked, and the answer to a step.
#pragma once

#include "axisc/answers/suggestion/suggestion.hpp"
#include "diagnostics/message.hpp"
#include "presentation/pictures/figure.hpp"

namespace axisc {

/// The present setting is dashed.
[[nodiscard]] pictures::Figure suggest_figure(Suggestion const& suggestion, Language language);

}  // namespace axisc
