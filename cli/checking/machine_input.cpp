#include "cli/checking/machine_input.hpp"

#include "cli/checking/compilable.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/options/report_format.hpp"

#include <algorithm>

namespace axisc::cli {

std::optional<validator::CheckResult> check_machine(CheckJob const& job, std::string const& path,
                                                    configuration::Files& files, Invocation const& invocation,
                                                    bool color) {
  SourceSet sources;
  auto result = validator::check(files, path, options_for(job, path), sources);
  if (result.unreadable) throw unreadable(path, *result.unreadable);
  std::erase_if(result.findings, [](Finding const& finding) { return finding.severity != Severity::error; });
  if (!result.findings.empty()) {
    invocation.streams.err.write(
        texts_of(result.findings, sources, {.language = invocation.language, .color = color}));
    return std::nullopt;
  }
  require_machine(path, result, sources, invocation.language);
  return result;
}

}  // namespace axisc::cli
