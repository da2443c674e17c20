// The options of a check, as text: options of the command line, settings of an editor.
#pragma once

#include "axisc/workspace/workspace.hpp"
#include "diagnostics/writers/report_writer.hpp"
#include "validator/check.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// As written by the user.
struct CheckingOptions {
  std::optional<std::string> cycle_time;
  std::optional<std::string> axis_type;
  std::optional<std::string> build;
  std::optional<std::string> kind;
  std::optional<std::string> threads;
  std::vector<std::string> disabled;
  std::vector<std::string> selected;  ///< if any: all others are disabled, but for those about the run (AX9)
  std::vector<std::string> schema_files;
  bool werror = false;
  bool quiet = false;
  bool pedantic = false;
  FindingFormat format = FindingFormat::text;
};

/// `--cycle-time`. Failure for an invalid value.
[[nodiscard]] std::optional<design::CycleTime> asked_cycle_time(std::optional<std::string> const& word);

/// Of a command that asks for nothing else about its inputs. Failure for an invalid value.
[[nodiscard]] Overrides overrides_with(std::optional<std::string> const& cycle_time,
                                       std::vector<std::string> schema_files = {});

/// Failure for an invalid value.
[[nodiscard]] validator::CheckOptions check_options(CheckingOptions const& given);

/// The value of -j; none without the option. Failure if it is not a positive number.
[[nodiscard]] std::optional<unsigned> asked_threads(std::optional<std::string> const& threads);
/// Threads for so many tasks: as many as `-j` asks for, otherwise one per processor. A single task needs one,
/// without asking the system.
[[nodiscard]] unsigned thread_count(std::optional<unsigned> asked, std::size_t tasks);

/// True if the findings lead to exit status 1.
[[nodiscard]] bool objectionable(CheckingOptions const& options, FindingCounts const& counts);

}  // namespace axisc
