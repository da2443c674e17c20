// The acceptance report of a machine as one HTML page: findings, axes, contours and changes, readable without
// a network and without scripts.
#pragma once

#include "axisc/answers/difference/difference_answer.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "diagnostics/finding.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

using ReportBlocks = std::vector<presentation::Block>;

/// A finding as the page shows it.
struct ReportedFinding {
  Severity severity = Severity::error;
  Code code{};
  std::string_view name;
  std::string text;  ///< as `lint` prints it
};

/// What the page is about.
struct ReportSubject {
  std::string input;
  std::vector<ReportedFinding> findings;
  FindingCounts counts;
  machine::Machine const* machine = nullptr;  ///< null after errors, and of an image
  std::optional<PlotSubject> plots;           ///< none after errors; `machine` of its state is set
  ShownDifference const* difference = nullptr;
  ContourRequest contour;
  ReportBlocks delays = {};  ///< the delay budget; none after errors
  Language language = Language::english;

  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({text, std::move(arguments)}, language);
  }
};

/// Findings beyond these are counted only: longer pages are not read.
inline constexpr std::size_t most_shown_findings = 500;

/// Counts a finding and keeps it as the page shows it.
void add_finding(ReportSubject& subject, Finding const& finding, SourceSet const& sources);

/// The whole document. Cost: some milliseconds per axis.
[[nodiscard]] std::string report_page(ReportSubject const& subject);

// Its parts. Findings are HTML: each leads to its explanation.
[[nodiscard]] std::string findings_section(ReportSubject const& subject);
[[nodiscard]] ReportBlocks changes_section(ReportSubject const& subject);
[[nodiscard]] ReportBlocks axes_section(ReportSubject const& subject);
[[nodiscard]] ReportBlocks channels_section(ReportSubject const& subject);
[[nodiscard]] ReportBlocks programs_section(ReportSubject const& subject);
[[nodiscard]] ReportBlocks explanations_section(ReportSubject const& subject);

}  // namespace axisc
