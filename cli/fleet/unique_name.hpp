// Names for files that nobody else makes at the same time.
#pragma once

#include <string>

namespace axisc::cli {

/// 32 hexadecimal digits: another text for every call, in every process, on every host.
[[nodiscard]] std::string unique_name();

}  // namespace axisc::cli
