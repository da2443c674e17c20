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
///        = fix: …
///     12 + filter[0].time_constant          5000       # dead time of the drive
/// Columns are code points. Tabs stay tabs, in the line and under it, so that the caret stands under its
/// token. Lines above 160 characters are cut around the caret with "…"; control characters are shown as
/// pictures. Related places follow as further snippets behind ":::", underlined with dashes. A finding
/// without place shows its file only. Ends with a line end; findings are meant to be separated by an empty
/// line.
[[nodiscard]] std::string write_text(Finding const& finding, SourceSet const& sources,
                                     WriteOptions const& options);

/// The last line, with its line end: "2 files: 3 errors, 1 warning", "1 file: no findings".
[[nodiscard]] std::string write_text_summary(std::size_t files, FindingCounts const& counts,
                                             WriteOptions const& options);

/// The JSON form of `axisc lint --format json`: all findings and the summary, one document, two-space
/// indentation, a line end behind it. Strings are well-formed UTF-8 whatever the source holds. What a finding
/// has not is null (place, parameter, p_axis, axis, control and its parts, fix) or an empty array.
/// `end_column` is the column behind the last character; `notes` holds the label, the notes and the help, in
/// this order. Cost: linear in the findings.
[[nodiscard]] std::string write_json(std::vector<Finding> const& findings, SourceSet const& sources,
                                     std::size_t files, WriteOptions const& options);

/// Order of every output: by source in input order, then line, then column, then code; equal ones keep their
/// order. Findings without place stand before all others, by file and code.
void sort_findings(std::vector<Finding>& findings);

}  // namespace axisc
