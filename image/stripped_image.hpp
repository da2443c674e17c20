// An image without what only people need.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::image {

/// The image as `compile --strip` would have written it: without names, self-tests, lists and values. A
/// signature is left out. Expects an image that read_image() accepted. Cost: a copy and the checksums.
[[nodiscard]] std::vector<std::byte> stripped_image(std::span<std::byte const> image);

}  // namespace axisc::image
