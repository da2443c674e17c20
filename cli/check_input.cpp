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
  SourceSet sources;
  auto options = options_for(job, path);
  options.machine = false;
  auto const* const settings = job.settings == nullptr ? nullptr : job.settings->find(path);
  FindingWriter writer(sources, form);
  auto const outcome = validator::check(files, path, options, sources, [&](Finding& finding) {
    if (settings != nullptr) {
      if (is_disabled(*settings, sources, finding)) return;
      finding.severity = severity_of(*settings, finding);
    }
    if (!job.quiet || finding.severity != Severity::note) writer.add(finding);
  });
  auto checked = std::move(writer).take();
  if (outcome.unreadable) checked.failure = unreadable(path, *outcome.unreadable);
  checked.files = outcome.files;
  return checked;
}

}  // namespace axisc::cli
