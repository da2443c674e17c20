// Checks one input with the settings that apply to it.
#pragma once

#include "axisc/checking/checked_input.hpp"
#include "axisc/checking/edited_files.hpp"
#include "axisc/settings/settings.hpp"
#include "axisc/workspace/inputs.hpp"
#include "validator/check.hpp"

#include <string>

namespace axisc {

struct CheckJob {
  validator::CheckOptions options;  ///< of the command line
  bool quiet = false;               ///< without notes
  EditedBytes edited;               ///< read instead of the files
  SettingsFinder* settings = nullptr;
  std::unordered_map<std::string, std::vector<std::string>> shown = {};  ///< see Inputs::shown
  std::unordered_map<std::string, FoundInput> found;                     ///< see Inputs::found
};

/// The job's options with the settings that apply to `path`.
[[nodiscard]] validator::CheckOptions options_for(CheckJob const& job, std::string const& path);

struct JudgedInput {
  FindingCounts counts;           ///< of the wanted findings
  validator::CheckResult result;  ///< the rest
};

// The functions below may be called by several threads. They throw errors that end the whole run.

/// Every wanted finding is passed to `take` as soon as it is known. `checked` receives the sources, the files
/// and the failure.
[[nodiscard]] JudgedInput judge_input(CheckJob const& job, std::string const& path,
                                      configuration::Files& files, CheckedInput& checked,
                                      TakeFinding const& take);
/// For callers that need only the findings: they are passed to `take`, or, where it is null, part of the
/// result.
[[nodiscard]] CheckedInput check_input(CheckJob const& job, std::string const& path,
                                       configuration::Files& files, TakeFinding const* take);

}  // namespace axisc
