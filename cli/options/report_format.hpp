// The output format of a run's findings.
#pragma once

#include "cli/options/check_options.hpp"
#include "diagnostics/writers/writers.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

struct ReportFormat {
  FindingFormat format = FindingFormat::text;
  WriteOptions write;
  ReportContext context;
};

/// True for formats that name rules, and paths relative to the repository.
[[nodiscard]] constexpr bool needs_context(FindingFormat format) {
  return format != FindingFormat::text && format != FindingFormat::json;
}

/// Appends one finding to `text`, with holes (report_elements.hpp) where it depends on the other findings.
void append_element(std::string& text, Finding const& finding, SourceSet const& sources,
                    ReportFormat const& report_format);

/// Findings as text, an empty line after each.
[[nodiscard]] std::string texts_of(std::vector<Finding> const& findings, SourceSet const& sources,
                                   WriteOptions const& options);

}  // namespace axisc::cli
