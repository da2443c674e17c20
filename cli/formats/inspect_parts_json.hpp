// Parts of `axisc inspect --format json`.
#pragma once

#include "image/image_contents.hpp"

#include <nlohmann/json.hpp>

namespace axisc::cli {

[[nodiscard]] nlohmann::ordered_json section_json(design::IncrementSection const& section,
                                                  bool blocks_constant, design::CycleTime cycle_time);
[[nodiscard]] nlohmann::ordered_json slot_json(image::ImageSlot const& slot);
[[nodiscard]] nlohmann::ordered_json kernel_json(image::ImageKernel const& kernel,
                                                 design::CycleTime cycle_time);
[[nodiscard]] nlohmann::ordered_json group_json(image::ImageContents const& image,
                                                image::ImageGroup const& group);
[[nodiscard]] nlohmann::ordered_json control_json(image::ImageContents const& image,
                                                  image::ImageControl const& control);

}  // namespace axisc::cli
