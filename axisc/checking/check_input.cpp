#include "axisc/checking/check_input.hpp"

#include "axisc/files/disk_files.hpp"
#include "diagnostics/location.hpp"

#include <algorithm>
#include <utility>

namespace axisc {

JudgedInput judge_input(Workspace& workspace, std::string const& path, CheckedInput& checked,
                        TakeFinding const& take) {
  auto& sources = checked.sources;
  JudgedInput judged;
  auto const* const shown = workspace.shown_of(path);
  auto const is_shown = [&](Finding const& finding) {
    return shown == nullptr ||
           std::find(shown->begin(), shown->end(), file_of(finding, sources)) != shown->end();
  };
  bool const has_notes = !workspace.overrides().quiet;
  judged.result =
      validator::check(workspace.files(), path, workspace.options_of(path), sources, [&](Finding& finding) {
        if (!has_notes && finding.severity == Severity::note) return;
        if (!is_shown(finding)) {
          checked.elsewhere.add(finding.severity);
          return;
        }
        judged.counts.add(finding.severity);
        take(std::move(finding), sources);
      });
  checked.files = shown == nullptr ? judged.result.files : *shown;
  if (judged.result.unreadable) checked.failure = unreadable(path, *judged.result.unreadable);
  return judged;
}

CheckedInput check_input(Workspace& workspace, std::string const& path, TakeFinding const* take) {
  CheckedInput checked;
  TakeFinding const keep = [&checked](Finding&& finding, SourceSet const&) {
    checked.findings.push_back(std::move(finding));
  };
  static_cast<void>(judge_input(workspace, path, checked, take == nullptr ? keep : *take));
  // Most lists have no finding: results that wait for their turn need not keep the text of such lists.
  if (take == nullptr && checked.findings.empty()) checked.sources = {};
  return checked;
}

}  // namespace axisc
