// What delays each axis of a machine, on the way of its position and on that of feedforward.
#pragma once

#include "diagnostics/source_text.hpp"
#include "presentation/document.hpp"
#include "validator/loading/loading.hpp"

#include <optional>

namespace axisc {

/// `feed` in mm/min; none: the lowest velocity limit (P-AXIS-00212) of each channel. An axis of which a
/// filter cannot be designed has no budget.
[[nodiscard]] presentation::Document delay_budget_answer(validator::LoadedMachine const& machine,
                                                         design::CycleTime cycle_time,
                                                         SourceSet const& sources,
                                                         std::optional<double> feed);

}  // namespace axisc
