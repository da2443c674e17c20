// One writer per output format. They return text, never write it.
#pragma once

#include "diagnostics/finding.hpp"

#include <string>
#include <vector>

namespace axisc {

struct WriteOptions {
  Language language = Language::english;
  bool color = false;  ///< ANSI colours in the text form
};

/// Shape of the text form:
///     error[AX3005]: the delay must be shorter than 6 NC cycles
///       --> axes/x.lis:12:34
///        |
///     12 | filter[0].time_constant          12000      # dead time of the drive
///        |                                  ^^^^^ 12000 µs are 12 cycles of 1000 µs
///        |
///        = P-AXIS-00357: 0 ≤ time_constant < 6 T for TIME_DELAY
///        = control: message 50663: …
///        = help: …
/// Long lines are cut around the caret; tabs are shown so that the caret stands under its token.
[[nodiscard]] std::string write_text(Finding const& finding, SourceSet const& sources,
                                     WriteOptions const& options);

/// The last line: "2 files: 3 errors, 1 warning".
[[nodiscard]] std::string write_text_summary(std::size_t files, FindingCounts const& counts,
                                             WriteOptions const& options);

/// The JSON form of `axisc lint --format json`: all findings and the summary, one document, two-space
/// indentation.
[[nodiscard]] std::string write_json(std::vector<Finding> const& findings, SourceSet const& sources,
                                     std::size_t files, WriteOptions const& options);

/// Order of every output: by source in input order, then line, then column, then code.
void sort_findings(std::vector<Finding>& findings);

}  // namespace axisc
