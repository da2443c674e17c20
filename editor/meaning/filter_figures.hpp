// Figures of a filter, for the hover over one of its parameters.
#pragma once

#include "diagnostics/sentence.hpp"
#include "editor/reading/open_list.hpp"

#include <string>
#include <string_view>

namespace axisc::editor {

/// Delay, overshoot and -3 dB frequency of the filter that `name` belongs to, or why there are none: Markdown
/// with a plot of the magnitude, or plain text; of a guard what it leaves. Empty for other names. Cost: less
/// than a millisecond.
[[nodiscard]] std::string filter_figures(OpenList const& list, std::string_view name, bool markdown,
                                         Language language);

}  // namespace axisc::editor
