// The control beside what axisc computes, drawn.
#pragma once

#include "axisc/answers/execution/recorded_axis.hpp"
#include "diagnostics/message.hpp"
#include "presentation/pictures/figure.hpp"

namespace axisc {

/// What `compare` computes, in the liveliest 2000 cycles: setpoint, recorded and computed position, the
/// difference of the two, and its spectrum; the reading that fits best beside what axisc computes. `axis` is
/// a name for people.
[[nodiscard]] pictures::Figure compare_figure(RecordedAxis const& recorded, std::string const& axis,
                                              double cycle_seconds, Language language);

}  // namespace axisc
