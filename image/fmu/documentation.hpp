// documentation/index.html of an FMU.
#pragma once

#include "image/fmu/model.hpp"

#include <string>

namespace axisc::image {

/// A page that says what variables mean, when they are read, and what an importer has to keep to. In English.
[[nodiscard]] std::string documentation(FmuModel const& model, ImageContents const& contents);

}  // namespace axisc::image
