// How long the filters of an axis delay its setpoint.
#pragma once

#include "machine/machine.hpp"
#include "validator/values/effective_values.hpp"

#include <optional>

namespace axisc::validator {

struct AxisDelay {
  double cycles = 0;  ///< at 0 Hz: of the active filter[i] and of the configured FIR or HSC filter
  /// The parameter that delays most; null if nothing delays. Valid while the EffectiveValues live.
  EffectiveValue const* cause = nullptr;
  std::optional<machine::ConfiguredKernel> kernel;
};

/// None if a filter cannot be designed: its delay is then unknown. Cost: one design per active filter.
[[nodiscard]] std::optional<AxisDelay> axis_delay(EffectiveValues const& values,
                                                  design::CycleTime cycle_time);

}  // namespace axisc::validator
