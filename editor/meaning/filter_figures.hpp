// What a filter of an open list does, for who points at one of its parameters.
#pragma once

#include "diagnostics/sentence.hpp"
#include "editor/reading/open_list.hpp"

#include <string>
#include <string_view>

namespace axisc::editor {

/// Delay, overshoot and -3 dB frequency of the filter that `name` belongs to, as Markdown with a picture of its magnitude, or as
/// text; empty for other names, and where the filter is off or cannot be designed. Cost: less than a millisecond.
[[nodiscard]] std::string filter_figures(OpenList const& list, std::string_view name, bool markdown,
                                         Language language);

}  // namespace axisc::editor
