// `axisc.json`: settings of a team for the lists of a folder and its subfolders.
//
//   {
//     "cycle_time_us": 1000,                      for lists alone; a machine file has its own
//     "build": "V3.1.3080.00",
//     "language": "de",
//     "design": {"filters": "no-prewarping", "kernels": "taps-n-plus-1"},   how the control computes filters
//     "motion": {"sine": "whole-change"},         how it plans a path
//     "disable": ["AX4007"],
//     "severity": {"AX3013": "error"},
//     "schema": ["build-3200.json"],              schema files, see schema_file.hpp; relative to this file
//     "paths": [{"pattern": "old/**", "disable": ["AX1011"]}, {"pattern": "tools/*.lis", "kind": "tool"}],
//     "include": ["listen/**"], "exclude": ["old/**"]     files to check in folders
//   }
//
// A severity determines the exit status, which finding of a token is kept, and whether an image is written,
// in every command; a code with a severity is checked without --pedantic, unless it is a note either way. A
// pattern is matched against the file that a finding is in: a default list and the lists of axes may have
// different rules.
//
// All keys are optional. The file is searched next to each input and in the folders above; only the nearest
// one applies. The command line overrides it.
#pragma once

#include "configuration/json_shape.hpp"
#include "diagnostics/finding.hpp"
#include "schema/catalogue.hpp"
#include "validator/check.hpp"

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace axisc {

inline constexpr std::string_view settings_file_name = "axisc.json";

struct PathSettings {
  std::string pattern;  ///< relative to the folder of the settings
  std::vector<Code> disabled;
  std::optional<schema::ListKind> kind;
};

struct Settings {
  std::string file;    ///< "lists/axisc.json"
  std::string folder;  ///< patterns begin here
  std::optional<design::CycleTime> cycle_time;
  std::optional<validator::BuildVersion> build;
  std::optional<Language> language;
  design::Readings readings;
  machine::MotionReadings motion;
  std::vector<Code> disabled;
  std::map<Code, Severity> severities;
  std::vector<PathSettings> paths;
  std::vector<std::string> included;  ///< patterns of the only files that are looked at in folders; none: all
  std::vector<std::string> excluded;  ///< patterns of files that are left out there
  std::vector<std::string> schema_files;
  schema::Catalogue catalogue;  ///< with these and those of the command line
};

/// Failure, with line and column, for anything that is not a settings file.
[[nodiscard]] Settings read_settings(std::string const& path, std::string const& folder);

/// The shape of a settings file.
extern configuration::JsonShape const settings_shape;

/// The settings of each folder, read once. May be used by several threads.
class SettingsFinder {
 public:
  /// `schema_files` are those of the command line; they are read after those of each axisc.json and override
  /// them.
  explicit SettingsFinder(std::vector<std::string> schema_files = {})
      : schema_files_(std::move(schema_files)) {}

  /// The settings for an input: the nearest axisc.json, null if there is none; for standard input that of the
  /// working folder. Valid as long as the finder. Cost: system calls once per folder.
  [[nodiscard]] Settings const* find(std::string const& input);
  /// The parameters that the lists of an input may set.
  [[nodiscard]] schema::Catalogue catalogue(std::string const& input);
  /// False for a file that `include` and `exclude` leave out where a folder holds it.
  [[nodiscard]] bool wants(std::string const& path);
  [[nodiscard]] std::vector<std::string> const& schema_files() const { return schema_files_; }

 private:
  void read_schema_files();
  [[nodiscard]] Settings const* look_for(std::string const& asked);

  std::vector<std::string> schema_files_;
  std::mutex mutex_;
  std::map<std::string, std::optional<Settings>> known_;    ///< by folder
  std::unordered_map<std::string, Settings const*> asked_;  ///< by folder as inputs write it
  std::optional<schema::Catalogue> without_settings_;       ///< with the command line's files alone
};

/// Appends the settings file and the schema files that apply to `input`.
void add_settings_files(SettingsFinder& finder, std::string const& input, std::vector<std::string>& files);

/// `options` of the command line, completed from the settings.
[[nodiscard]] validator::CheckOptions with_settings(validator::CheckOptions options, Settings const& settings,
                                                    std::string const& input);

/// The output of `lint --print-config` for one input: each setting, and where it comes from.
[[nodiscard]] std::string describe_settings(std::string const& input,
                                            validator::CheckOptions const& command_line,
                                            std::vector<std::string> const& schema_files,
                                            Settings const* settings, Language language);

}  // namespace axisc
