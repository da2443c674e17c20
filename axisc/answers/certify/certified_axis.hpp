// The certificate of an axis.
#pragma once

#include "image/checked_bounds.hpp"
#include "image/image_contents.hpp"
#include "presentation/document.hpp"

#include <cstddef>

namespace axisc {

/// Sentences about the setpoint chain, and a table of all its chains with all kernels.
[[nodiscard]] presentation::Section certified_axis(image::ImageContents const& image, std::size_t axis,
                                                   image::CheckedBounds const& checked);

}  // namespace axisc
