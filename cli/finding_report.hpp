// The findings of a run in the form that was asked for.
#pragma once

#include "cli/checking.hpp"
#include "diagnostics/writers.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

/// Findings as text, an empty line behind each.
[[nodiscard]] std::string texts_of(std::vector<Finding> const& findings, SourceSet const& sources,
                                   WriteOptions const& options);

/// The documents of the other formats. `findings` are numbered (fingerprint.hpp).
[[nodiscard]] std::string document_of(FindingFormat format, std::vector<Finding> const& findings,
                                      SourceSet const& sources, RunFacts const& run,
                                      ReportContext const& context, WriteOptions const& options);

}  // namespace axisc::cli
