// Checks one input with the settings that apply to it.
#pragma once

#include "cli/checking/checked_input.hpp"
#include "cli/checking/edited_files.hpp"
#include "cli/options/inputs.hpp"
#include "cli/settings/settings.hpp"
#include "validator/check.hpp"

#include <string>

namespace axisc::cli {

struct CheckJob {
  validator::CheckOptions options;  ///< of the command line
  bool quiet = false;               ///< without notes
  EditedBytes edited;               ///< read instead of the files
  SettingsFinder* settings = nullptr;
  std::optional<std::string> shown = std::nullopt;  ///< the only file of the input whose findings are wanted
  std::unordered_map<std::string, FoundInput> found;  ///< see Inputs::found
};

/// The job's options with the settings that apply to `path`.
[[nodiscard]] validator::CheckOptions options_for(CheckJob const& job, std::string const& path);

/// An input whose findings are written.
struct JudgedInput {
  CheckedInput checked;           ///< without findings: `take` had them
  FindingCounts counts;           ///< of those
  validator::CheckResult result;  ///< the rest of it
};

// The functions below may be called by several threads. They throw what must end the whole run.

/// Every finding is passed to `take` as soon as it is written. `sources` receives every text read.
[[nodiscard]] JudgedInput judge_input(CheckJob const& job, std::string const& path,
                                      configuration::Files& files, ReportFormat const& report_format,
                                      SourceSet& sources, TakeFinding const& take);
/// For callers that need only the findings.
[[nodiscard]] CheckedInput check_input(CheckJob const& job, std::string const& path,
                                       configuration::Files& files, ReportFormat const& report_format,
                                       TakeFinding const& take);
/// The findings are in the result.
[[nodiscard]] CheckedInput check_input(CheckJob const& job, std::string const& path,
                                       configuration::Files& files, ReportFormat const& report_format);

}  // namespace axisc::cli
