// An FMU of a machine's filters.
#pragma once

#include "axisc/exporting/exported_image.hpp"
#include "axisc/exporting/fmu_libraries.hpp"
#include "image/fmu/fmu.hpp"

#include <string>
#include <vector>

namespace axisc {

struct ExportedFmu {
  std::string archive;                 ///< the bytes of the file
  std::vector<std::string> libraries;  ///< their names within it
  std::vector<Message> missing;        ///< libraries that could not be made
};

/// Failure where two axes or two channels of the image have one name.
[[nodiscard]] ExportedFmu exported_fmu(ImageFile const& image, image::FmuOptions options,
                                       std::vector<image::FmuPlatform> const& platforms);

/// The name that an output file gives its model: "mill" for "out/mill.fmu".
[[nodiscard]] std::string model_name(std::string const& path);

}  // namespace axisc
