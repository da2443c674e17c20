// What axisrt_c needs in memory.
#pragma once

#include "image/image_contents.hpp"

#include <cstddef>

namespace axisc::image {

/// At least what axisrt_c_memory_size() says, on every processor: for arrays that compilers size. The same
/// number on every host.
[[nodiscard]] std::size_t runtime_size(ImageContents const& contents);

}  // namespace axisc::image
