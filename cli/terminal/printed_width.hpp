// The width of what is printed.
#pragma once

#include "system/process.hpp"

#include <algorithm>
#include <cstddef>

namespace axisc::cli {

/// Columns of the terminal that standard output is, at least 40; 80 where it is none.
[[nodiscard]] inline std::size_t printed_width() {
  constexpr std::size_t narrowest = 40;
  constexpr std::size_t usual = 80;
  return std::max(system::terminal_width().value_or(usual), narrowest);
}

}  // namespace axisc::cli
