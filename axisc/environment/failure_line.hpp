// The last line that the program prints when an exception ends it.
#pragma once

#include "diagnostics/message.hpp"

#include <string>

namespace axisc {

/// The exception that is being handled, as one line with its end. To be called in a catch block.
[[nodiscard]] std::string failure_line(Language language);

}  // namespace axisc
