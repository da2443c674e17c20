#include "axisc/checking/check_input.hpp"

#include "diagnostics/location.hpp"

#include <algorithm>
#include <utility>

namespace axisc {

validator::CheckOptions options_for(CheckJob const& job, std::string const& path) {
  auto options = job.options;
  if (auto const found = job.found.find(path); found != job.found.end()) {
    options.from_folder = true;
    options.is_beside_start_up_list = found->second.is_beside_start_up_list;
  }
  if (job.settings == nullptr) return options;
  options.catalogue = job.settings->catalogue(path);
  auto const* const settings = job.settings->find(path);
  return settings == nullptr ? options : with_settings(std::move(options), *settings, path);
}

JudgedInput judge_input(CheckJob const& job, std::string const& path, configuration::Files& files,
                        CheckedInput& checked, TakeFinding const& take) {
  auto& sources = checked.sources;
  JudgedInput judged;
  auto const shown = job.shown.find(path);
  auto const is_shown = [&](Finding const& finding) {
    if (shown == job.shown.end()) return true;
    auto const& names = shown->second;
    return std::find(names.begin(), names.end(), file_of(finding, sources)) != names.end();
  };
  judged.result = validator::check(files, path, options_for(job, path), sources, [&](Finding& finding) {
    bool const is_wanted = !job.quiet || finding.severity != Severity::note;
    if (!is_wanted) return;
    if (!is_shown(finding)) {
      checked.elsewhere.add(finding.severity);
      return;
    }
    judged.counts.add(finding.severity);
    take(std::move(finding), sources);
  });
  checked.files = shown == job.shown.end() ? judged.result.files : shown->second;
  if (judged.result.unreadable) checked.failure = unreadable(path, *judged.result.unreadable);
  return judged;
}

CheckedInput check_input(CheckJob const& job, std::string const& path, configuration::Files& files,
                         TakeFinding const* take) {
  CheckedInput checked;
  TakeFinding const keep = [&checked](Finding&& finding, SourceSet const&) {
    checked.findings.push_back(std::move(finding));
  };
  static_cast<void>(judge_input(job, path, files, checked, take == nullptr ? keep : *take));
  // Most lists have no finding: results that wait for their turn need not keep the text of such lists.
  if (take == nullptr && checked.findings.empty()) checked.sources = {};
  return checked;
}

}  // namespace axisc
