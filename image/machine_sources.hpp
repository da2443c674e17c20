// machine.c and machine.h: an image as sources in C, which exports contain.
#pragma once

#include "image/image_contents.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace axisc::image {

/// The image, or what `compile --strip` would have made of it; a signature is left out. Expects an image that
/// read_image() accepted, with its contents.
[[nodiscard]] std::vector<std::byte> exported_image(std::span<std::byte const> image,
                                                    ImageContents const& contents, bool complete);

/// "#FILTER ON [ORDER=60]"
[[nodiscard]] std::string bank_text(ImageBank const& bank);
/// The axis' name; "axis0" for the first axis of a stripped image.
[[nodiscard]] std::string axis_text(ImageContents const& contents, std::size_t axis);

/// What an export has in its header beyond others.
struct MachineHeader {
  std::string definitions;  ///< lines of macros
  std::string numbers;      ///< ", NAME = NUMBER" for the enumeration
};

/// machine.h: number of axes, NC cycle time, the image's declaration; its comment says which axis and which
/// bank has which number.
[[nodiscard]] std::string machine_header(ImageContents const& contents, MachineHeader const& more = {});
/// machine.c: the image as an array.
[[nodiscard]] std::string machine_source(std::span<std::byte const> bytes);

}  // namespace axisc::image
