#include "cli/checking/check_input.hpp"

#include "diagnostics/location.hpp"
#include "validator/loading/loader.hpp"

#include <utility>

namespace axisc::cli {

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
                        ReportFormat const& report_format, SourceSet& sources, TakeFinding const& take) {
  FindingWriter writer(sources, report_format, take);
  JudgedInput judged;
  auto const is_shown = [&](Finding const& finding) {
    return !job.shown || validator::key_of(std::string(file_of(finding, sources))) == *job.shown;
  };
  judged.result = validator::check(files, path, options_for(job, path), sources, [&](Finding const& finding) {
    bool const is_wanted = !job.quiet || finding.severity != Severity::note;
    if (is_wanted && is_shown(finding)) writer.add(finding);
  });
  judged.counts = writer.counts();
  judged.checked.artifacts = writer.artifacts();
  judged.checked.files = job.shown ? std::vector{*job.shown} : judged.result.files;
  if (judged.result.unreadable) judged.checked.failure = unreadable(path, *judged.result.unreadable);
  return judged;
}

CheckedInput check_input(CheckJob const& job, std::string const& path, configuration::Files& files,
                         ReportFormat const& report_format, TakeFinding const& take) {
  SourceSet sources;
  return judge_input(job, path, files, report_format, sources, take).checked;
}

CheckedInput check_input(CheckJob const& job, std::string const& path, configuration::Files& files,
                         ReportFormat const& report_format) {
  std::deque<WrittenFinding> findings;
  auto checked = check_input(job, path, files, report_format, keep_in(findings));
  checked.findings = std::move(findings);
  return checked;
}

}  // namespace axisc::cli
