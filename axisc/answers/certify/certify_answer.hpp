// What holds for every input of the chains of an image, as an answer.
#pragma once

#include "axisc/files/image_file.hpp"
#include "image/checked_bounds.hpp"
#include "presentation/document.hpp"

#include <optional>
#include <string>

namespace axisc {

struct CertifyQuestion {
  std::string image;                ///< its path, for readers
  std::optional<std::string> axis;  ///< none: all
};

/// `checked` is that of the image. Failure for an unknown axis.
[[nodiscard]] presentation::Document certify_answer(CertifyQuestion const& question, ImageFile const& file,
                                                    image::CheckedBounds const& checked);

}  // namespace axisc
