// Weight, limit and drive scaling of Improved Position Control, each rounded once.
#pragma once

#include "configuration/machine/machine.hpp"

namespace axisc::codegen {

/// min(numerator/denominator, 7.0)
[[nodiscard]] double stage_weight(machine::PositionControlStage const& stage);

/// v_add_max_fact/1000 · v_max in the unit of v_max (µm/s or 1e-3 °/s).
[[nodiscard]] double velocity_limit(machine::PositionControl const& control, double v_max);

/// Drive increments per µm/s (1e-3 °/s). Position control
///   in the drive  v_reso_num/v_reso_denom, distances in 1 µm (0.001°): ·60 per minute, ·1 per second,
///                 ·T per NC cycle
///   in the CNC    6e-5 · multi_gain_z/multi_gain_n
///   not known     0
[[nodiscard]] double increments_per_velocity(machine::DriveScaling const& scaling,
                                             design::CycleTime cycle_time);

}  // namespace axisc::codegen
