// The filters of a machine as sources in C99, which are valid C++14 too.
#pragma once

#include "image/image_contents.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace axisc::image {

struct ExportedFile {
  std::string name;  ///< in its folder
  std::string content;
};

struct CSourcesOptions {
  bool complete = false;  ///< the array keeps names, self-tests, lists and values
};

/// The runtime (axisrt_c.c, axisrt_c.h), the image as an array with the numbers of its axes and banks
/// (machine.c, machine.h), and a program that uses them (example.c). Expects an image that read_image()
/// accepted, with its contents. The same bytes for the same image.
[[nodiscard]] std::vector<ExportedFile> c_sources(std::span<std::byte const> image,
                                                  ImageContents const& contents,
                                                  CSourcesOptions const& options = {});

}  // namespace axisc::image
