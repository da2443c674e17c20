// The value of a number token. The grammar recognises a number; this function converts it, correctly
// rounded.
#pragma once

#include <optional>
#include <string_view>

namespace axisc::grammar {

/// The double nearest to an `integer` or `real` token; none when it is too big for a double (or `token` is
/// neither). A value too small for a double is 0.
[[nodiscard]] std::optional<double> real_value(std::string_view token);

}  // namespace axisc::grammar
