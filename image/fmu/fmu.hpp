// A machine's filters as a Functional Mock-up Unit: description, sources, image, documentation.
#pragma once

#include "image/c_sources.hpp"
#include "image/fmu/model.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::image {

struct Fmu {
  std::string identifier;           ///< of the model; names its libraries
  std::vector<ExportedFile> files;  ///< modelDescription.xml, sources/…, of which *.c make its library, …
};

/// Everything but libraries. Expects an image that read_image() accepted, with its contents. The same files
/// for the same image and options.
[[nodiscard]] std::variant<Fmu, EqualNames> fmu_of(std::span<std::byte const> image,
                                                   ImageContents const& contents, FmuOptions const& options);

/// A system that a library may be for.
struct FmuPlatform {
  std::string_view key;                    ///< as `--binaries` has it: linux64
  std::string_view suffix;                 ///< of the library: ".so"
  std::array<std::string_view, 2> folder;  ///< of FMI 2.0 and 3.0
};
inline constexpr FmuPlatform linux64{"linux64", ".so", {"linux64", "x86_64-linux"}};
inline constexpr FmuPlatform win64{"win64", ".dll", {"win64", "x86_64-windows"}};

/// Its name within the FMU: "binaries/x86_64-linux/mill.so".
[[nodiscard]] std::string library_name(Fmu const& fmu, FmiVersion version, FmuPlatform const& platform);

}  // namespace axisc::image
