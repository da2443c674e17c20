// Planes as written on the command line.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace axisc {

/// Two of the axes, "XY" or "X,Y". Failure for anything else.
[[nodiscard]] std::pair<std::size_t, std::size_t> asked_plane(std::string const& word,
                                                              std::vector<std::string> const& axes);

}  // namespace axisc
