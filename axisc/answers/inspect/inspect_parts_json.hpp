// Parts of `axisc inspect --format json`.
#pragma once

#include "image/image_contents.hpp"

#include <string_view>

#include <nlohmann/json.hpp>

namespace axisc {

[[nodiscard]] nlohmann::ordered_json section_json(design::IncrementSection const& section,
                                                  bool blocks_constant, design::CycleTime cycle_time);
/// Adds "reading" and "computed_for", where they are not `documented`.
void add_readings(nlohmann::ordered_json& json, std::string_view reading, std::string_view cycle_time);
[[nodiscard]] nlohmann::ordered_json slot_json(image::ImageSlot const& slot);
[[nodiscard]] nlohmann::ordered_json kernel_json(image::ImageKernel const& kernel,
                                                 design::CycleTime cycle_time);
[[nodiscard]] nlohmann::ordered_json group_json(image::ImageContents const& image,
                                                image::ImageGroup const& group);
[[nodiscard]] nlohmann::ordered_json control_json(image::ImageContents const& image,
                                                  image::ImageControl const& control);

}  // namespace axisc
