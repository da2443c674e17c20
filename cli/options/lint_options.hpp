// The command line of `axisc lint`.
#pragma once

#include "axisc/checking/fixing.hpp"
#include "cli/options/check_options.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

/// The least severity that leads to exit status 1; `warning` is --werror.
enum class FailOn : std::uint8_t { error, warning, never };

struct LintOptions {
  CheckingOptions checking;
  std::vector<std::string> named;
  std::optional<std::string> changed_since;
  std::optional<std::string> baseline;
  std::optional<std::string> write_baseline;
  std::optional<std::string> fix;
  std::optional<std::string> stdin_filename;
  FailOn fail_on = FailOn::error;
  bool hook = false;
  bool alone = false;
  bool diff = false;
  bool statistics = false;
  bool print_config = false;
};

void declare(CommandLine& command_line, LintOptions& options);
/// Failure for options that exclude each other.
void require_sense(CommandLine const& command_line, LintOptions const& options);
[[nodiscard]] FixChoice fix_choice(LintOptions const& options);
/// True if this run looks for the code: only then can a baseline entry for it be stale.
[[nodiscard]] bool is_judged(LintOptions const& given, validator::CheckOptions const& options, Code code);

}  // namespace axisc::cli
