// Figures of a Vibration Guard, for hovers.
#pragma once

#include "design/kernels/kernel_design.hpp"
#include "diagnostics/sentence.hpp"
#include "validator/values/effective_values.hpp"

#include <string>

namespace axisc::editor {

/// "mode 2 at 30 Hz, delay 14.1 ms, at most 5 % left from 25 to 35.3 Hz (a reading)".
[[nodiscard]] std::string guard_text(design::KernelSpecification const& guard, design::CycleTime cycle_time,
                                     Language language);

/// The guard of an axis' lists, active or not, as a sentence; why there is none where its values give none.
[[nodiscard]] std::string listed_guard_text(validator::EffectiveValues const& values,
                                            design::CycleTime cycle_time, Language language);

}  // namespace axisc::editor
