// The readings of the control that an image was made for.
#pragma once

#include "design/readings.hpp"
#include "image/image_contents.hpp"

#include <cstddef>
#include <string>

namespace axisc::image {

/// The readings of the setpoint chain and the linear-phase kernel of one axis.
[[nodiscard]] design::Readings readings_of(ImageContents const& contents, std::size_t axis);

/// "filters: no-prewarping, cycle_time: double": the keys and words of settings; "documented" without any.
[[nodiscard]] std::string readings_text(design::Readings const& readings);

}  // namespace axisc::image
