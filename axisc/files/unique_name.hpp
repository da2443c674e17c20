// Unique names for files.
#pragma once

#include <string>

namespace axisc {

/// Letters, digits and dashes: different for every call, in every process, on every host.
[[nodiscard]] std::string unique_name();

}  // namespace axisc
