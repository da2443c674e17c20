// The pages that editors show of a machine: what `report`, `plot` and `machine` write, of documents as they are in the editor.
#pragma once

#include "editor/machine_context.hpp"
#include "editor/pages.hpp"

namespace axisc::cli {

/// `axisc.report`, `axisc.plot KIND`, `axisc.machine` and `axisc.explain CODE`, and the line above a cascade. `options` outlives them.
[[nodiscard]] editor::Pages editor_pages(editor::OptionsOf const& options);

}  // namespace axisc::cli
