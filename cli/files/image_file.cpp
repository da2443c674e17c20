#include "cli/files/image_file.hpp"

#include "cli/codes.hpp"
#include "cli/files/disk_files.hpp"

#include <array>
#include <span>
#include <variant>

namespace axisc::cli {

namespace {

Text sentence(axisrt_status status) {
  switch (status) {
    case AXISRT_WRONG_MAGIC:
      return Text::ax9004_magic;
    case AXISRT_TOO_SHORT:
      return Text::ax9004_short;
    case AXISRT_WRONG_VERSION:
      return Text::ax9004_version;
    case AXISRT_WRONG_SIZE:
      return Text::ax9004_size;
    case AXISRT_WRONG_CHECKSUM:
      return Text::ax9004_checksum;
    default:
      return Text::ax9004;
  }
}

}  // namespace

Failure unusable_image(std::string const& path, axisrt_status status) {
  return Failure({.text = sentence(status),
                  .arguments = {{"file", path},
                                {"status", axisrt_status_name(status)},
                                {"reason", axisrt_status_text(status)}}},
                 not_an_image);
}

ImageFile load_image(std::string const& path) {
  auto const text = read_whole(path);
  codegen::AlignedBytes bytes(std::as_bytes(std::span(text)));
  auto contents = image::read_image(bytes.bytes());
  if (auto const* const status = std::get_if<axisrt_status>(&contents)) throw unusable_image(path, *status);
  return {.bytes = std::move(bytes), .contents = std::get<image::ImageContents>(std::move(contents))};
}

std::string axis_label(image::ImageContents const& image, std::size_t axis) {
  auto const& name = image.axes[axis].name;
  return name.empty() ? "axis" + std::to_string(axis) : name;
}

std::vector<std::size_t> chosen_axes(image::ImageContents const& image,
                                     std::optional<std::string> const& name) {
  std::vector<std::size_t> chosen;
  std::vector<std::string> labels;
  for (std::size_t axis = 0; axis < image.axes.size(); ++axis) {
    labels.push_back(axis_label(image, axis));
    if (!name || *name == labels.back()) chosen.push_back(axis);
  }
  if (!name || !chosen.empty()) return chosen;
  std::string known;
  for (auto const& label : labels) known += (known.empty() ? "" : ", ") + label;
  throw Failure({.text = Text::cli_unknown_axis, .arguments = {{"axis", *name}, {"axes", known}}});
}

std::string_view port_name(Port port) {
  switch (port) {
    case Port::setpoint:
      return "setpoint";
    case Port::interface:
      return "interface";
    case Port::velocity:
      return "velocity";
  }
  return {};
}

std::uint32_t level_of(std::optional<std::string> const& word) {
  static constexpr std::array<std::pair<std::string_view, std::uint32_t>, 6> levels = {
      {{"portable", AXISRT_LEVEL_PORTABLE},
       {"auto", AXISRT_LEVEL_AUTOMATIC},
       {"v2", AXISRT_LEVEL_X86_64_V2},
       {"v3", AXISRT_LEVEL_X86_64_V3},
       {"v4", AXISRT_LEVEL_X86_64_V4},
       {"neon", AXISRT_LEVEL_NEON}}};
  if (!word) return AXISRT_LEVEL_PORTABLE;
  for (auto const& [name, level] : levels) {
    if (*word == name) return level;
  }
  throw Failure(
      {.text = Text::cli_bad_choice,
       .arguments = {
           {"option", "--level"}, {"value", *word}, {"choices", "portable, auto, v2, v3, v4, neon"}}});
}

image::RuntimeHost start_runtime(std::string const& path, ImageFile const& file, std::uint32_t level) {
  auto host = image::RuntimeHost::create(file.bytes.bytes(), std::nullopt, level);
  if (auto const* const status = std::get_if<axisrt_status>(&host)) {
    if (*status == AXISRT_NO_LEVEL) throw Failure({.text = Text::cli_no_level, .arguments = {}});
    throw unusable_image(path, *status);
  }
  return std::get<image::RuntimeHost>(std::move(host));
}

}  // namespace axisc::cli
