// docs/image-format.md, made from the format's table of fields.
#pragma once

#include <string>

namespace axisc::docs {

/// The whole document.
[[nodiscard]] std::string image_format_document();

}  // namespace axisc::docs
