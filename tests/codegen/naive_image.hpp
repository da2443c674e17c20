// A second writer of images, as plain as possible: written from docs/image-format.md alone, with its own
// checksum and its own evaluation of the self-tests. It shares only the filter design with the compiler.
#pragma once

#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace axisc::test {

struct NaiveOptions {
  bool strip = false;
  std::uint32_t image_version = 0;
  std::string compiler_version;
};

[[nodiscard]] std::vector<std::byte> naive_image(machine::Machine const& machine,
                                                 NaiveOptions const& options);

/// Bit by bit.
[[nodiscard]] std::uint32_t naive_crc32c(std::vector<std::byte> const& bytes, std::size_t begin,
                                         std::size_t end);

}  // namespace axisc::test
