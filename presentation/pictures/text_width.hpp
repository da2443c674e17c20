// How wide text is in a picture, without a font at hand: an upper estimate for the sans-serif fonts that
// readers have.
#pragma once

#include <string>
#include <string_view>

namespace axisc::pictures {

/// In pixels, for UTF-8 in a font of `size` pixels.
[[nodiscard]] double text_width(std::string_view text, double size);

/// The text, or as much of it as fits into `width` followed by an ellipsis.
[[nodiscard]] std::string fitted(std::string_view text, double size, double width);

}  // namespace axisc::pictures
