// Writes an image and reports the outcome.
#pragma once

#include "axisc/checking/compile_input.hpp"

#include <string>
#include <vector>

namespace axisc {

enum class ImageFate : std::uint8_t {
  missing,
  unchanged,
  written,
  skipped,  ///< the input is a list of another kind, of which no image is made
};

struct ImageTarget {
  std::string path;
  std::optional<std::string> depfile;  ///< written with the image
  bool makes_folder = false;           ///< where there is none yet
};

struct WrittenImage {
  CheckedInput checked;
  ImageFate fate = ImageFate::missing;
  std::vector<std::string> sources;  ///< every file that the image depends on
  std::size_t bytes = 0;
  std::size_t axes = 0;
  std::size_t filters = 0;
};

/// Writes the image unless the file already has the same content. `more_sources` are sources that the input
/// does not name itself. A write error is a failure of the input.
[[nodiscard]] WrittenImage write_image(CompiledInput compiled, ImageTarget const& target,
                                       std::vector<std::string> const& more_sources);

}  // namespace axisc
