// Context of reports for code hosts: the rules, the version, and the repository root.
#pragma once

#include "diagnostics/writers/writers.hpp"

#include <string>

namespace axisc {

/// The repository is that of the working folder, else that of the first input; where there is none, paths are
/// relative to the working folder.
[[nodiscard]] ReportContext report_context(std::string const& first_input);

}  // namespace axisc
