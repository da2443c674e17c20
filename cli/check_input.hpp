// One input of many: checked with the settings that apply to it.
#pragma once

#include "cli/checked_input.hpp"
#include "cli/edited_files.hpp"
#include "cli/settings.hpp"
#include "validator/check.hpp"

#include <string>

namespace axisc::cli {

struct CheckJob {
  validator::CheckOptions options;
  bool quiet = false;  ///< without notes
  EditedBytes edited;  ///< read instead of the files
  SettingsFinder* settings = nullptr;
};

/// The job's options with the settings that apply to `path`.
[[nodiscard]] validator::CheckOptions options_for(CheckJob const& job, std::string const& path);

/// May be called by several threads. Throws what has to end the whole run.
[[nodiscard]] CheckedInput check_input(CheckJob const& job, std::string const& path, validator::Files& files,
                                       ReportForm const& form);
/// The same, but every finding goes to `take` as soon as it is written, instead of into the result.
[[nodiscard]] CheckedInput check_input(CheckJob const& job, std::string const& path, validator::Files& files,
                                       ReportForm const& form, TakeFinding const& take);

}  // namespace axisc::cli
