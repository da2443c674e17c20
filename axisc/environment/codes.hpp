// The codes that the program itself reports.
#pragma once

#include "diagnostics/finding.hpp"

namespace axisc {

inline constexpr Code cannot_read{9001};
inline constexpr Code cannot_write{9002};
inline constexpr Code too_large{9003};
inline constexpr Code not_an_image{9004};
inline constexpr Code csv_malformed{9005};
inline constexpr Code cycle_time_assumed{9006};
inline constexpr Code plant_file{9009};

}  // namespace axisc
