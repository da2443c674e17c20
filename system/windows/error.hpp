// Error numbers of Windows.
#pragma once

#include "system/error.hpp"

namespace axisc::system {

[[nodiscard]] Error error_of(unsigned long number);
/// The error that GetLastError() stands for.
[[nodiscard]] Error last_error();

}  // namespace axisc::system
