// Error numbers of POSIX.
#pragma once

#include "system/error.hpp"

namespace axisc::system {

[[nodiscard]] Error error_of(int number);
/// The error that errno stands for.
[[nodiscard]] Error last_error();

}  // namespace axisc::system
