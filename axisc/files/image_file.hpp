// A coefficient image from the disk.
#pragma once

#include "axisc/environment/failure.hpp"
#include "axisrt.h"
#include "codegen/aligned_bytes.hpp"
#include "image/image_contents.hpp"
#include "image/runtime_host.hpp"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc {

struct ImageFile {
  codegen::AlignedBytes bytes;
  image::ImageContents contents;
};

/// Reads and verifies; "-" is standard input. Failure AX9001 for a file that cannot be read, AX9004 for a
/// damaged image or a file that is not an image.
[[nodiscard]] ImageFile load_image(std::string const& path);
/// The bytes of an image that lies elsewhere; `path` is its name in messages.
[[nodiscard]] ImageFile image_of_bytes(std::string const& path, std::string_view image);

/// Failure AX9004 with the status of the runtime.
[[nodiscard]] Failure unusable_image(std::string const& path, axisrt_status status);

/// The axis' name; "axis0" for the first axis of a stripped image.
[[nodiscard]] std::string axis_label(image::ImageContents const& image, std::size_t axis);

/// For a name that is not among `labels`, the names of all axes.
[[nodiscard]] Failure unknown_axis(std::string const& name, std::vector<std::string> const& labels);

/// Indices of the axes to show: all of them, or the one that `--axis` names. Failure for an unknown name.
[[nodiscard]] std::vector<std::size_t> chosen_axes(image::ImageContents const& image,
                                                   std::optional<std::string> const& name);

enum class Port : std::uint8_t { setpoint, interface, velocity };

inline std::initializer_list<std::pair<std::string_view, Port>> const ports = {
    {"setpoint", Port::setpoint}, {"interface", Port::interface}, {"velocity", Port::velocity}};
[[nodiscard]] std::string_view port_name(Port port);

/// Values of `--level`, for help and messages.
inline constexpr std::string_view level_names = "portable|auto|v2|v3|v4|neon";

/// The axisrt_level for a value of `--level`; portable without one, because its results are the same
/// everywhere.
/// Failure for another value.
[[nodiscard]] std::uint32_t level_of(std::optional<std::string> const& word);

/// The runtime for a loaded image at an axisrt_level. Failure AX9004 if the self-tests fail on this
/// processor; another Failure if it does not have that level.
[[nodiscard]] image::RuntimeHost start_runtime(std::string const& path, ImageFile const& file,
                                               std::uint32_t level = AXISRT_LEVEL_PORTABLE);

}  // namespace axisc
