// A text of a file with its place.
#pragma once

#include "diagnostics/source_text.hpp"

#include <string>

namespace axisc::configuration {

/// In UTF-8; a keyword of a table is in the table's spelling.
struct LocatedText {
  std::string text;
  Place place;
};

}  // namespace axisc::configuration
