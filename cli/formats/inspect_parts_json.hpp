// Parts of `axisc inspect --format json`.
#pragma once

#include "image/image_contents.hpp"

#include <nlohmann/json.hpp>

namespace axisc::cli {

[[nodiscard]] nlohmann::ordered_json section_json(design::IncrementSection const& section,
                                                  bool blocks_constant, design::CycleTime cycle_time);
[[nodiscard]] nlohmann::ordered_json slot_json(codegen::ImageSlot const& slot);
[[nodiscard]] nlohmann::ordered_json kernel_json(codegen::ImageKernel const& kernel,
                                                 design::CycleTime cycle_time);
[[nodiscard]] nlohmann::ordered_json group_json(codegen::ImageContents const& image,
                                                codegen::ImageGroup const& group);
[[nodiscard]] nlohmann::ordered_json control_json(codegen::ImageContents const& image,
                                                  codegen::ImageControl const& control);

}  // namespace axisc::cli
