// Options that `lint` and `compile` share: those of the check and the format of its findings.
#pragma once

#include "cli/options/command_line.hpp"
#include "diagnostics/writers/report_writer.hpp"
#include "validator/check.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

/// As written on the command line.
struct CheckingOptions {
  std::optional<std::string> cycle_time;
  std::optional<std::string> axis_type;
  std::optional<std::string> build;
  std::optional<std::string> kind;
  std::optional<std::string> threads;
  std::vector<std::string> disabled;
  std::vector<std::string> schema_files;
  bool werror = false;
  bool quiet = false;
  bool pedantic = false;
  FindingFormat format = FindingFormat::text;
};

/// What lists and machine files do not say of their control.
void declare_control(CommandLine& command_line, CheckingOptions& options);
/// Those and all others.
void declare_checking(CommandLine& command_line, CheckingOptions& options);
/// `--schema FILE`, which every command that reads lists has.
void declare_schema(CommandLine& command_line, std::vector<std::string>& files);

/// `--cycle-time`. Failure for an invalid value.
[[nodiscard]] std::optional<design::CycleTime> asked_cycle_time(std::optional<std::string> const& word);

/// Failure for a value that means nothing.
[[nodiscard]] validator::CheckOptions check_options(CheckingOptions const& given);

/// `-j N`, which every command that works on several inputs has.
void declare_threads(CommandLine& command_line, std::optional<std::string>& threads);

/// The value of -j; none without the option. Failure if it is not a positive number.
[[nodiscard]] std::optional<unsigned> asked_threads(std::optional<std::string> const& threads);
/// Threads for so many tasks: as many as `-j` asks for, otherwise one per processor. A single task needs one, without
/// asking the system.
[[nodiscard]] unsigned thread_count(std::optional<unsigned> asked, std::size_t tasks);

/// True if the findings lead to exit status 1.
[[nodiscard]] bool objectionable(CheckingOptions const& options, FindingCounts const& counts);

}  // namespace axisc::cli
