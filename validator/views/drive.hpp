// The drive of an axis, and where its position is controlled. The machine file overrides the lists.
#pragma once

#include "configuration/machine/drive_type.hpp"
#include "diagnostics/wording.hpp"
#include "validator/loading/loading.hpp"

namespace axisc::validator {

/// The machine file's drive, else that of P-AXIS-00020, set or not; null for a number that is not documented.
[[nodiscard]] machine::DriveType const* drive_of(LoadedAxis const& axis);

/// The drive that the machine file or a list states; null where neither does.
[[nodiscard]] machine::DriveType const* stated_drive(LoadedAxis const& axis);

/// As messages call it: "simulation", in German "Antriebssimulation".
[[nodiscard]] Wording drive_name(machine::DriveType const& drive);

/// Where the position is controlled: from the machine file, else from P-AXIS-00320, else by drive type;
/// unknown for an open position loop, and if the lists' values cannot be used.
[[nodiscard]] machine::PositionController position_controller(LoadedAxis const& axis);

/// P-AXIS-00320 is one of OPEN_POSITION_LOOP_…
[[nodiscard]] bool is_open_loop(EffectiveValue const& operation_mode);

}  // namespace axisc::validator
