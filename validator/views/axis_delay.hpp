// How long the filters of an axis delay its setpoint.
#pragma once

#include "configuration/machine/machine.hpp"
#include "validator/values/effective_values.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::validator {

/// The contribution of one filter of the axis.
struct DelayShare {
  std::string filter;  ///< `filter[0]`, `filter_fir`, `vib_guard`
  double cycles = 0;
  EffectiveValue const* cause = nullptr;  ///< its parameter; valid while the EffectiveValues live
};

struct AxisDelay {
  double cycles =
      0;  ///< at 0 Hz: of the active filter[i], the configured FIR or HSC filter, the active guard
  std::vector<DelayShare> shares;                    ///< in the order of the chain
  std::vector<design::FilterSpecification> filters;  ///< the active filter[i], without HSC
  /// The parameter that delays most; null if nothing delays. Valid while the EffectiveValues live.
  EffectiveValue const* cause = nullptr;
  std::optional<machine::ConfiguredKernel> kernel;
};

/// None if a filter cannot be designed: its delay is then unknown. Cost: one design per active filter.
[[nodiscard]] std::optional<AxisDelay> axis_delay(EffectiveValues const& values,
                                                  design::CycleTime cycle_time);

/// Without a FIR or HSC filter that waits for its command.
[[nodiscard]] AxisDelay at_start(AxisDelay delay);

}  // namespace axisc::validator
