// Libraries of an FMU, made by the compilers that are installed.
#pragma once

#include "diagnostics/message.hpp"
#include "image/fmu/fmu.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// The systems that `--binaries` names: "linux64,win64", "none", or "auto" for all that are known. Failure
/// for another word.
[[nodiscard]] std::vector<image::FmuPlatform> library_platforms(std::string_view word);

struct FmuLibraries {
  std::vector<image::ExportedFile> files;
  std::vector<Message> missing;  ///< why one could not be made
};

/// Compiles the sources in a folder for temporary files. The same compiler gives the same bytes. Cost: a
/// second for each system.
[[nodiscard]] FmuLibraries fmu_libraries(image::Fmu const& fmu, image::FmiVersion version,
                                         std::vector<image::FmuPlatform> const& platforms);

}  // namespace axisc
