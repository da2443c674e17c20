// The report about a machine as one HTML page, for a customer and for a merge request: a cover that says
// whether the machine may run, what its filters cost and what must be done; findings, changes, axes,
// contours, programs; an appendix. Readable without a network and without scripts.
#pragma once

#include "axisc/answers/difference/difference_answer.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/report/report_answer.hpp"
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
  std::string axis;   ///< empty where none is concerned, or several are
  std::string place;  ///< "listen/x.lis:12"
  Message message;
  std::optional<Message> help;
  std::string text;  ///< as `lint` prints it
};

/// Findings of one rule and one severity.
struct FindingGroup {
  Severity severity = Severity::error;
  Code code{};
  std::vector<ReportedFinding const*> findings;
};

/// Contours of a channel, or why there are none: its axes cannot follow a path.
struct ReportedContour {
  std::optional<GroupContour> figures;
  std::string reason;
};

/// What the page is about.
struct ReportSubject {
  std::string input;  ///< as named, for messages
  ReportCover cover;  ///< with a title
  std::vector<ReportedFinding> findings;
  FindingCounts counts;
  std::size_t files = 0;                      ///< that were checked
  machine::Machine const* machine = nullptr;  ///< null after errors
  std::optional<PlotSubject> plots;           ///< none after errors; `machine` of its state is set
  ShownDifference const* difference = nullptr;
  ContourRequest contour;
  std::vector<ReportedContour> contours = {};  ///< of each channel of the machine
  ReportBlocks delays = {};                    ///< the delay budget; none after errors
  Language language = Language::english;

  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({text, std::move(arguments)}, language);
  }
  /// Blocks with headings from `level` on.
  [[nodiscard]] std::string html(ReportBlocks const& blocks, int level) const;
  [[nodiscard]] double highest_feed() const;
};

/// Findings beyond these are counted only: longer pages are not read.
inline constexpr std::size_t most_shown_findings = 500;

/// Counts a finding and keeps it as the page shows it.
void add_finding(ReportSubject& subject, Finding const& finding, SourceSet const& sources);
/// The worst first, then those with most findings.
[[nodiscard]] std::vector<FindingGroup> groups_of(std::vector<ReportedFinding> const& findings);

/// The whole document. Cost: some milliseconds per axis.
[[nodiscard]] std::string report_page(ReportSubject const& subject);

// Its parts.
struct ReportCoverPage {
  std::string html;
  bool has_whole_overview = false;  ///< else it has a part of its own
};
/// Title, verdict, costs, what must be done, and lines to sign, on one page of paper.
[[nodiscard]] ReportCoverPage report_cover(ReportSubject const& subject);
/// The first table and how to read it: HTML; only without errors.
[[nodiscard]] std::string report_overview(ReportSubject const& subject);
/// A row for each group of findings, with what must be done.
[[nodiscard]] presentation::Table to_do_table(ReportSubject const& subject);
[[nodiscard]] ReportBlocks findings_section(ReportSubject const& subject);
[[nodiscard]] ReportBlocks changes_section(ReportSubject const& subject);
[[nodiscard]] ReportBlocks axes_section(ReportSubject const& subject);
[[nodiscard]] ReportBlocks channels_section(ReportSubject const& subject);
[[nodiscard]] ReportBlocks programs_section(ReportSubject const& subject);
/// Sources with their checksums, the delay budget, every finding, and explanations of the rules.
[[nodiscard]] ReportBlocks appendix_section(ReportSubject const& subject);

}  // namespace axisc
