// The report about a machine, for its customer and for those who change it.
#pragma once

#include "axisc/answers/contour/contour_groups.hpp"
#include "axisc/checking/machine_input.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// What only people know. Each is one line as the cover shows it; empty: what the machine file says, if
/// anything. No clock is asked, so that the same input gives the same bytes.
struct ReportCover {
  std::string title = {};  ///< empty: the machine's name
  std::string customer = {}, author = {}, date = {};
};

struct ReportQuestion {
  std::string input;  ///< a list, a machine, or a folder with one machine
  ReportCover cover = {};
  std::optional<std::string> before = {};  ///< an earlier state: adds every change and its effect
  /// Without a tolerance the machine file's counts.
  ContourRequest contour = {.feeds = {1000, 2000, 4000}, .tolerance_mm = {}};
  bool alone = false;
  Language language = Language::english;
};

struct ReportAnswer {
  std::string page;  ///< HTML
  FindingCounts counts;
  std::vector<std::string> files = {};  ///< that were read, with those of settings
};

/// Of a list it is the page of its machine. None where the lists of the earlier state, or both, have errors
/// that leave nothing to compare: `errors` takes them. Errors of the present state are part of the page.
/// `notes` takes notes about files that are skipped. Failure for inputs that cannot be read, or are no
/// machine.
[[nodiscard]] std::optional<ReportAnswer> report_answer(Workspace& workspace, ReportQuestion const& question,
                                                        ErrorSink const& errors, std::vector<Message>& notes);

}  // namespace axisc
