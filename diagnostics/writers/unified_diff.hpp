// The difference of two texts as a unified diff, for `patch` and `git apply`.
#pragma once

#include <string>
#include <string_view>

namespace axisc {

/// Three lines of context; empty for equal texts. Bytes stay as they are, so line ends and encodings pass
/// through `patch` unharmed. Cost: linear where lines are replaced one by one, as fixes and `fmt` do;
/// otherwise the search for the next common line looks 32 lines ahead.
[[nodiscard]] std::string unified_diff(std::string_view name, std::string_view before,
                                       std::string_view after);

}  // namespace axisc
