// The output format of a run's findings.
#pragma once

#include "axisc/checking/checking_options.hpp"
#include "diagnostics/writers/report_writer.hpp"

#include <string>
#include <vector>

namespace axisc {

struct ReportFormat {
  FindingFormat format = FindingFormat::text;
  WriteOptions write;
  ReportContext context;
};

/// Findings as text, an empty line after each.
[[nodiscard]] std::string texts_of(std::vector<Finding> const& findings, SourceSet const& sources,
                                   WriteOptions const& options);

}  // namespace axisc
