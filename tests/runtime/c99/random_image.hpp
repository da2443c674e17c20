// Images with random contents of every kind that the format has: filters that no list would give included.
#pragma once

#include "runtime/image_builder.hpp"

#include <cstdint>

namespace axisc::test {

/// The same image for the same seed on every host. One seed in eight has so many forms of chains that not all
/// of them are grouped.
[[nodiscard]] ImageRecord random_image(std::uint32_t seed);

}  // namespace axisc::test
