// What the program says before it ends because of an exception.
#pragma once

#include "diagnostics/message.hpp"

#include <string>

namespace axisc {

/// The exception that is being handled, as one line with its end. To be called in a catch block.
[[nodiscard]] std::string failure_line(Language language);

}  // namespace axisc
