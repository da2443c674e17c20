// Error numbers of Windows.
#pragma once

#include "system/error.hpp"

namespace axisc::system {

[[nodiscard]] Error error_of(unsigned long number);
/// Of GetLastError().
[[nodiscard]] Error last_error();

}  // namespace axisc::system
