// The answer of `identify`.
#pragma once

#include "axisc/answers/identify/identified_axis.hpp"
#include "presentation/document.hpp"

namespace axisc {

[[nodiscard]] presentation::Document identify_answer(IdentifiedAxis const& found);

}  // namespace axisc
