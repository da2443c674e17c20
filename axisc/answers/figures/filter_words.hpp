// The filters of an axis in the reader's words: "band-stop 42 Hz, low-pass 60 Hz".
#pragma once

#include "image/image_contents.hpp"
#include "presentation/value.hpp"

#include <cstddef>
#include <optional>

namespace axisc {

/// Of the setpoint, in the order in which they act; one that starts off says so. None without a filter.
[[nodiscard]] std::optional<presentation::Words> filter_words(image::ImageContents const& contents,
                                                              std::size_t axis);

}  // namespace axisc
