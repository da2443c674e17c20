// Findings as text, and the parts that reports of several formats share. Functions return text and never
// print it.
#pragma once

#include "diagnostics/finding.hpp"
#include "diagnostics/fingerprint.hpp"
#include "diagnostics/page.hpp"
#include "diagnostics/repository_path.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct WriteOptions {
  Language language = Language::english;
  bool color = false;      ///< ANSI colours in the text form
  std::size_t width = 80;  ///< columns into which lines of sources are cut in the text form, at least 40
};

struct AppliedFix {
  std::string file;
  std::uint32_t line = 0;
  Message title;
};

/// Numbers of the findings that are not shown, by reason.
struct FixFacts {
  std::size_t applied = 0;
  std::vector<AppliedFix> named = {};  ///< of those, the ones that text lists individually
  std::size_t left_out = 0;            ///< fixes that would have led to further findings
};
struct BaselineFacts {
  std::size_t hidden = 0;
  std::vector<Identity> stale;                         ///< entries that no finding matches any more
  std::optional<std::size_t> recorded = std::nullopt;  ///< a baseline was written with this many entries
};

/// The numbers in a run's summary.
struct RunFacts {
  std::size_t files = 0;
  std::optional<FixFacts> fixes = std::nullopt;
  std::optional<BaselineFacts> baseline = std::nullopt;
  bool statistics = false;            ///< `codes` is wanted
  FindingCounts counts = {};          ///< of the findings shown
  std::vector<CodeCount> codes = {};  ///< of those, the most frequent first
  bool has_summary = true;            ///< text ends with the numbers
};

/// A rule as described to other tools.
struct RuleFacts {
  Code code{};
  std::string_view name;
  Severity severity = Severity::error;
  std::string_view control;  ///< the control's message numbers, "50663/60311"; may be empty
  Page page;                 ///< may be empty
};

/// Context that formats of code hosts need besides the findings.
struct ReportContext {
  std::vector<RuleFacts> rules;  ///< by rising code
  std::string version;           ///< of the program: "0.1.0"
  RepositoryPaths paths;
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
/// Columns are code points. Tabs stay tabs, in the line and under it, so that the caret is under its token.
/// Lines of sources are cut around the caret with "…" where they are wider than the terminal; control
/// characters are shown as pictures.
/// Findings with the same words about the same text are printed once; their other places follow at the end of
/// the report.
/// Related places follow as further snippets after ":::", underlined with dashes. A finding without place
/// shows its file only. Ends with a line end; findings are meant to be separated by an empty line.
[[nodiscard]] std::string write_text(Finding const& finding, SourceSet const& sources,
                                     WriteOptions const& options);

/// The last line, with its line end: "2 files: 3 errors, 1 warning", "1 file: no findings". `failures` inputs
/// could not be checked, so that nothing is known about them.
[[nodiscard]] std::string write_text_summary(std::size_t files, FindingCounts const& counts,
                                             WriteOptions const& options, std::size_t failures = 0);

/// The lines between the findings and the summary: stale entries of the baseline, and the applied fixes. May
/// be empty.
[[nodiscard]] std::string write_text_facts(RunFacts const& run, WriteOptions const& options);

/// A table, one line per code: count, code, name, and how many of them carry a fix.
[[nodiscard]] std::string write_text_statistics(std::vector<CodeCount> const& counts,
                                                WriteOptions const& options);

/// The complete text of a finding, for formats that have one message only: the headline, then a line for each
/// of label, notes, control, help and fix.
[[nodiscard]] std::string whole_message(Finding const& finding, Language language,
                                        Values values = Values::as_given);

/// "message 50663: the filter is switched off; runs with 0"; empty if nothing is known.
void append_control_text(std::string& text, Finding const& finding, Language language, Values values);
/// True if anything is known about the control's reaction.
[[nodiscard]] bool has_control_text(Finding const& finding);

}  // namespace axisc
