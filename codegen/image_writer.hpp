// From the checked machine to the bytes of an image.
#pragma once

#include "codegen/known_designs.hpp"
#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace axisc::codegen {

struct ImageOptions {
  bool strip = false;               ///< leave out names, source map and self-tests
  bool bounds = false;              ///< with the section `bounds`
  std::uint32_t image_version = 0;  ///< monotonic counter of the machine's maker
};

/// Byte-identical for equal machines and options, on every host and at every optimisation level.
[[nodiscard]] std::vector<std::byte> write_image(machine::Machine const& machine,
                                                 ImageOptions const& options);
/// The image of one of many machines; filters that were designed for another one are reused.
[[nodiscard]] std::vector<std::byte> write_image(machine::Machine const& machine, ImageOptions const& options,
                                                 KnownDesigns& designs);

}  // namespace axisc::codegen
