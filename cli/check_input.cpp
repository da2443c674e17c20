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

void apply_settings_of(CheckJob const& job, std::string const& path, SourceSet const& sources,
                       std::vector<Finding>& findings) {
  auto const* const settings = job.settings == nullptr ? nullptr : job.settings->find(path);
  if (settings != nullptr) apply_settings(*settings, sources, findings);
  if (!job.quiet) return;
  std::erase_if(findings, [](Finding const& finding) { return finding.severity == Severity::note; });
}

CheckedInput check_input(CheckJob const& job, std::string const& path, validator::Files& files,
                         ReportForm const& form) {
  SourceSet sources;
  auto options = options_for(job, path);
  options.machine = false;
  auto outcome = validator::check(files, path, options, sources);
  if (outcome.unreadable) {
    CheckedInput checked;
    checked.failure = unreadable(path, *outcome.unreadable);
    return checked;
  }
  apply_settings_of(job, path, sources, outcome.findings);
  auto checked = write_findings(outcome.findings, sources, form);
  checked.files = std::move(outcome.files);
  return checked;
}

}  // namespace axisc::cli
