// The embedded pages; the table itself is written by cmake/EmbedPages.cmake when the program is built.
#pragma once

#include "diagnostics/finding.hpp"

#include <span>
#include <string_view>

namespace axisc {

struct PageTexts {
  Code code{};
  std::string_view english;  ///< Markdown without the heading; empty where the page is missing
  std::string_view german;
};

/// Every page, in the order of the codes.
[[nodiscard]] std::span<PageTexts const> page_table();

}  // namespace axisc
