// What drives an axis, and where its position is controlled: the machine file says it before the lists.
#pragma once

#include "machine/drive_type.hpp"
#include "validator/loading/loading.hpp"

namespace axisc::validator {

/// The machine file's drive, else that of P-AXIS-00020, set or not; null for a number that is not documented.
[[nodiscard]] machine::DriveType const* drive_of(LoadedAxis const& axis);

/// Machine file, else P-AXIS-00320, else by drive type; unknown for an open position loop, and where the lists' values
/// cannot be used.
[[nodiscard]] machine::PositionController position_controller(LoadedAxis const& axis);

/// P-AXIS-00320 is one of OPEN_POSITION_LOOP_…
[[nodiscard]] bool is_open_loop(EffectiveValue const& operation_mode);

}  // namespace axisc::validator
