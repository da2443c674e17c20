// Helpers for writing SVG.
#pragma once

#include <string>
#include <string_view>

namespace axisc::pictures {

/// With two decimals at most and no trailing zeros: a hundredth of a pixel cannot be seen. `value` is finite.
[[nodiscard]] std::string pixels(double value);

/// ` name="value"`.
[[nodiscard]] std::string attribute(std::string_view name, std::string_view value);
[[nodiscard]] std::string attribute(std::string_view name, double value);

}  // namespace axisc::pictures
