// One writer per format of a run's findings. Findings are data until they come here, and each is written
// once, in the order of the report. Writers append text that the caller prints.
#pragma once

#include "diagnostics/writers/writers.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace axisc {

enum class FindingFormat : std::uint8_t { text, json, jsonl, sarif, github, gitlab, junit };

class ReportWriter {
 public:
  using Print = std::function<void(std::string_view)>;

  ReportWriter() = default;
  ReportWriter(ReportWriter const&) = delete;
  ReportWriter& operator=(ReportWriter const&) = delete;
  virtual ~ReportWriter() = default;

  /// The beginning of the report; also of one without findings.
  virtual void begin(std::string& /*out*/) {}
  /// One finding. `fingerprint` (see fingerprint.hpp) is empty unless the format has fingerprints.
  virtual void add(std::string& out, Finding const& finding, SourceSet const& sources,
                   std::string_view fingerprint) = 0;
  /// A finding about the run as a whole, which some formats list separately.
  virtual void add_notice(std::string& out, Finding const& finding, SourceSet const& sources,
                          std::string_view fingerprint) {
    add(out, finding, sources, fingerprint);
  }
  /// An input that could not be read, as a sentence.
  virtual void add_failure(std::string const& /*sentence*/) {}
  /// After the last finding of an input.
  virtual void end_input(SourceSet const& /*sources*/) {}
  /// The rest of the report, in pieces. Called once.
  virtual void end(Print const& /*print*/, RunFacts const& /*run*/) {}
};

/// True for formats that name each finding by its fingerprint.
[[nodiscard]] constexpr bool has_fingerprints(FindingFormat format) {
  return format == FindingFormat::sarif || format == FindingFormat::gitlab;
}
/// True for formats of code hosts, which need a context.
[[nodiscard]] constexpr bool needs_context(FindingFormat format) {
  return has_fingerprints(format) || format == FindingFormat::github || format == FindingFormat::junit;
}

[[nodiscard]] std::unique_ptr<ReportWriter> report_writer(FindingFormat format, WriteOptions const& options,
                                                          ReportContext context = {});

// Memory: that of one finding. SARIF and JUnit keep their results as text, because their heads name the rules
// and files of all, or count them.

/// See writers.hpp for the shape of a finding.
[[nodiscard]] std::unique_ptr<ReportWriter> text_report(WriteOptions const& options);

/// One document: all findings and the summary, two-space indentation. Strings are well-formed UTF-8 whatever
/// the source contains. Absent properties of a finding are null (place, parameter, p_axis, axis, control and
/// its parts, fix) or an empty array. `end_column` is the column after the last character; `notes` holds the
/// label, the notes and the help, in this order. Only if the run has them: `fixed` and `baseline` in the
/// summary, `statistics` after it.
[[nodiscard]] std::unique_ptr<ReportWriter> json_report(WriteOptions const& options);

/// The objects of json_report(), one a line, and nothing else: parts of a run can be concatenated.
[[nodiscard]] std::unique_ptr<ReportWriter> json_lines_report(WriteOptions const& options);

/// SARIF 2.1.0: one run, paths relative to the repository, columns in code points, the pages of the rules as
/// help.
[[nodiscard]] std::unique_ptr<ReportWriter> sarif_report(WriteOptions const& options, ReportContext context);

/// One workflow command of GitHub Actions a line: "::error file=…,line=…,…,title=…::message".
[[nodiscard]] std::unique_ptr<ReportWriter> github_report(WriteOptions const& options, ReportContext context);

/// A code quality report of GitLab, one line per finding: errors are major, warnings minor, notes info.
[[nodiscard]] std::unique_ptr<ReportWriter> gitlab_report(WriteOptions const& options, ReportContext context);

/// A JUnit report: one failed test per finding, its type the severity; without findings one test that passed.
[[nodiscard]] std::unique_ptr<ReportWriter> junit_report(WriteOptions const& options, ReportContext context);

}  // namespace axisc
