// Numbers as the words of a program write them.
#pragma once

#include <optional>
#include <string_view>

namespace axisc::motion {

/// "01" of G01; nothing for anything but a whole number.
[[nodiscard]] std::optional<int> whole_number(std::string_view digits);

/// "+5", "-.5"; nothing for anything but a finite number.
[[nodiscard]] std::optional<double> real_number(std::string_view text);

}  // namespace axisc::motion
