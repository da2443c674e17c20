// Checks inputs side by side and puts what was found into one collection, in input order.
#pragma once

#include "cli/edited_files.hpp"
#include "cli/failure.hpp"
#include "cli/settings.hpp"
#include "diagnostics/writers.hpp"
#include "validator/check.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

struct CheckJob {
  validator::CheckOptions options;
  bool quiet = false;  ///< without notes
  bool text_at_once =
      false;  ///< findings become text as soon as an input is checked, and their sources are dropped
  WriteOptions write;
  EditedBytes edited;  ///< read instead of the files
  SettingsFinder* settings = nullptr;
};

/// The job's options with the settings that apply to `path`.
[[nodiscard]] validator::CheckOptions options_for(CheckJob const& job, std::string const& path);
/// What the settings that apply to `path` make of the findings there.
void apply_settings_of(CheckJob const& job, std::string const& path, SourceSet const& sources,
                       std::vector<Finding>& findings);

/// One input, checked.
struct Checked {
  std::vector<Finding> findings;  ///< none with `text_at_once`
  SourceSet sources;              ///< none with `text_at_once`
  std::string text;               ///< only with `text_at_once`
  FindingCounts counts;
  std::vector<CodeCount> codes;
  std::vector<std::string> files;
  std::optional<Failure> failure;
};

/// One result per path. AX9006, the assumed cycle time, is kept once: as the first finding of the first input that has
/// it. Cost: memory for all findings, unless they become text at once.
[[nodiscard]] std::vector<Checked> check_inputs(CheckJob const& job, std::vector<std::string> const& paths,
                                                unsigned threads);

struct Collected {
  std::vector<Finding> findings;
  SourceSet sources;
};

/// Moves the findings of all inputs together and numbers the occurrences.
[[nodiscard]] Collected collect(std::vector<Checked>& results);

}  // namespace axisc::cli
