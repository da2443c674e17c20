// The XML files of an FMU.
#pragma once

#include "image/fmu/model.hpp"

#include <span>
#include <string>
#include <string_view>

namespace axisc::image {

/// modelDescription.xml. `sources`: names of the files that are compiled, which FMI 2.0 lists in it.
[[nodiscard]] std::string model_description(FmuModel const& model, FmuOptions const& options,
                                            std::span<std::string_view const> sources);

/// sources/buildDescription.xml of FMI 3.0.
[[nodiscard]] std::string build_description(FmuModel const& model, std::span<std::string_view const> sources);

}  // namespace axisc::image
