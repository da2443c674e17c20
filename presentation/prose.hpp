// Pages of prose as blocks, for formats that do not understand Markdown.
#pragma once

#include "presentation/document.hpp"

#include <vector>

namespace axisc::presentation {

/// Paragraphs, whose `code` and **bold** the writers know, tables and code.
[[nodiscard]] std::vector<Block> blocks_of(Prose const& prose, Language language);

}  // namespace axisc::presentation
