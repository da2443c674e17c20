// Helpers for the rules about Improved Position Control.
#pragma once

#include "validator/engine/rule.hpp"
#include "validator/views/position_control_view.hpp"

#include <vector>

namespace axisc::validator::checks {

[[nodiscard]] inline LoadedAxis const& loaded(AxisContext const& axis) {
  return axis.machine.axes[axis.index];
}

/// Points to where a list enables the function.
void relate_enable(Finding& finding, PositionControlView const& view);
/// Points to where a list sets the stage's mode.
void relate_mode(Finding& finding, StageView const& stage);

/// Values that a list sets.
using SetValues = std::vector<EffectiveValue const*>;
/// The value whose line comes last; null if there are none.
[[nodiscard]] EffectiveValue const* last_of(SetValues const& values);

/// Calls `visit(stage, damping)` for the damping of each vibration that a stage simulates, in INDIRECT and
/// SET_POINT; a stage that lacks it has AX3030.
template <typename Visit>
void for_each_damping(AxisContext const& axis, Visit visit) {
  for (StageView const& stage : axis.position_control.active_stages()) {
    if (stage.simulates() && configured(stage.damping())) visit(stage, stage.damping());
  }
}

}  // namespace axisc::validator::checks
