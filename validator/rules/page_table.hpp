// The embedded pages of the rules; the table itself is written by cmake/EmbedPages.cmake when the program is
// built.
#pragma once

#include "diagnostics/page.hpp"

#include <span>

namespace axisc::validator {

/// One page per rule, in the order of the codes.
[[nodiscard]] std::span<Page const> page_table();
/// Their headings, in the same order.
[[nodiscard]] std::span<Page const> page_title_table();

}  // namespace axisc::validator
