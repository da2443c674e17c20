// Figures of a Vibration Guard, for hovers.
#pragma once

#include "design/kernels/kernel_design.hpp"
#include "diagnostics/sentence.hpp"
#include "validator/loading/loading.hpp"

#include <string>

namespace axisc::editor {

/// Significant digits of computed figures.
inline constexpr int shown_digits = 3;

/// "mode 2 at 30 Hz, delay 14.1 ms, at most 5 % left from 25 to 35.3 Hz (a reading), axis error 2680 µm at a
/// corner of 90° at 30000 mm/min (vb_max)": between two axes with the guard, at P-AXIS-00212 of `axis`; no
/// error of an axis that is not translatory or has no velocity.
[[nodiscard]] std::string guard_text(design::KernelSpecification const& guard,
                                     validator::LoadedAxis const& axis, design::CycleTime cycle_time,
                                     Language language);

/// The guard of an axis' lists, active or not, as a sentence; why there is none where its values give none.
[[nodiscard]] std::string listed_guard_text(validator::LoadedAxis const& axis, design::CycleTime cycle_time,
                                            Language language);

}  // namespace axisc::editor
