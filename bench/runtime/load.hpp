// How fast an image is checked.
#pragma once

#include <cstddef>
#include <span>

namespace axisc::bench {

/// Prints GB/s (best of 15) of the checksum alone and of the whole of axisrt_verify for an image.
void report_load(std::span<std::byte const> image);

}  // namespace axisc::bench
