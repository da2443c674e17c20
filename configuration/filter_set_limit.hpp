// How many #FILTER commands a machine may use.
#pragma once

#include <cstddef>

namespace axisc::configuration {

/// Different parameter sets in one group: each becomes a bank of kernels, and the transitions between all of
/// them are computed.
inline constexpr std::size_t most_filter_sets = 1000;

}  // namespace axisc::configuration
