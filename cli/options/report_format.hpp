// How the findings of a run are written.
#pragma once

#include "cli/options/check_options.hpp"
#include "diagnostics/writers.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

struct ReportFormat {
  FindingFormat format = FindingFormat::text;
  WriteOptions write;
  ReportContext context;
};

/// The format names rules and paths as code hosts do.
[[nodiscard]] constexpr bool needs_context(FindingFormat format) {
  return format != FindingFormat::text && format != FindingFormat::json;
}

/// One finding behind `text`, with holes (report_elements.hpp) where it depends on the others.
void append_element(std::string& text, Finding const& finding, SourceSet const& sources,
                    ReportFormat const& report_format);

/// Findings as text, an empty line behind each.
[[nodiscard]] std::string texts_of(std::vector<Finding> const& findings, SourceSet const& sources,
                                   WriteOptions const& options);

}  // namespace axisc::cli
