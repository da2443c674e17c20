// `axisc.json`: what a team has agreed on for the lists of a folder and those below it.
//
//   {
//     "cycle_time_us": 1000,                      for lists alone; a machine file says its own
//     "build": "V3.1.3080.00",
//     "language": "de",
//     "disable": ["AX4007"],
//     "severity": {"AX3013": "error"},
//     "paths": [{"pattern": "old/**", "disable": ["AX1011"]}]
//   }
//
// All keys are optional. The file is looked for beside each input and upwards; the nearest one counts alone. What the
// command line says wins.
#pragma once

#include "diagnostics/finding.hpp"
#include "validator/check.hpp"

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

struct PathSettings {
  std::string pattern;  ///< relative to the folder of the settings
  std::vector<Code> disabled;
};

struct Settings {
  std::string file;    ///< "lists/axisc.json"
  std::string folder;  ///< patterns begin here
  std::optional<design::CycleTime> cycle_time;
  std::optional<validator::BuildVersion> build;
  std::optional<Language> language;
  std::vector<Code> disabled;
  std::map<Code, Severity> severities;
  std::vector<PathSettings> paths;

  /// Some pattern fits `path` and names `code`.
  [[nodiscard]] bool disables(std::string const& path, Code code) const;
};

/// Failure, with line and column, for anything that is no settings file.
[[nodiscard]] Settings read_settings(std::string const& path, std::string const& folder);

/// The settings of each folder, read once. May be used by several threads.
class SettingsFinder {
 public:
  /// Those that apply to an input; none where no axisc.json stands beside or above it, and for standard input that of the
  /// working folder.
  [[nodiscard]] std::optional<Settings> find(std::string const& input);

 private:
  std::mutex mutex_;
  std::map<std::string, std::optional<Settings>> known_;  ///< by folder
};

/// `options` of the command line, filled up with what the settings say.
[[nodiscard]] validator::CheckOptions with_settings(validator::CheckOptions options, Settings const& settings,
                                                    std::string const& input);

/// Takes out what the settings disable for a finding's file, and gives the others the severity they are to have.
void apply_settings(Settings const& settings, SourceSet const& sources, std::vector<Finding>& findings);

/// What `lint --print-config` shows for one input: each setting, and where it comes from.
[[nodiscard]] std::string describe_settings(std::string const& input,
                                            validator::CheckOptions const& command_line,
                                            std::optional<Settings> const& settings, Language language);

}  // namespace axisc::cli
