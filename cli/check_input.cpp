#include "cli/check_input.hpp"

#include <utility>

namespace axisc::cli {

validator::CheckOptions options_for(CheckJob const& job, std::string const& path) {
  if (job.settings == nullptr) return job.options;
  auto options = job.options;
  options.catalogue = job.settings->catalogue(path);
  auto const* const settings = job.settings->find(path);
  return settings == nullptr ? options : with_settings(std::move(options), *settings, path);
}

CheckedInput check_input(CheckJob const& job, std::string const& path, validator::Files& files,
                         ReportForm const& form) {
  std::deque<WrittenFinding> findings;
  auto checked = check_input(job, path, files, form, keep_in(findings));
  checked.findings = std::move(findings);
  return checked;
}

CheckedInput check_input(CheckJob const& job, std::string const& path, validator::Files& files,
                         ReportForm const& form, TakeFinding const& take) {
  SourceSet sources;
  auto options = options_for(job, path);
  options.machine = false;
  auto const* const settings = job.settings == nullptr ? nullptr : job.settings->find(path);
  FindingWriter writer(sources, form, take);
  auto const outcome = validator::check(files, path, options, sources, [&](Finding& finding) {
    if (settings != nullptr) {
      if (is_disabled(*settings, sources, finding)) return;
      finding.severity = severity_of(*settings, finding);
    }
    if (!job.quiet || finding.severity != Severity::note) writer.add(finding);
  });
  CheckedInput checked;
  checked.artifacts = writer.artifacts();
  if (outcome.unreadable) checked.failure = unreadable(path, *outcome.unreadable);
  checked.files = outcome.files;
  return checked;
}

}  // namespace axisc::cli
