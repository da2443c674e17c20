// The one call that most users of this folder need: sources in, findings and (when there is no error) a
// machine out.
#pragma once

#include "configuration/files.hpp"
#include "diagnostics/finding.hpp"
#include "machine/machine.hpp"
#include "validator/not_compiled.hpp"
#include "validator/options.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::validator {

struct CheckResult {
  std::vector<Finding> findings;  ///< in output order; empty where a sink takes them
  /// Only where it is wanted, without errors, not of an NC program, and not of a machine file in which something cannot be
  /// understood, even where AX4020 is silenced.
  std::optional<machine::Machine> machine;
  std::vector<NotCompiled> not_compiled;  ///< configured features that `machine` does not contain
  bool cycle_time_known = false;          ///< the options or the machine file give it
  bool cycle_time_assumed = false;        ///< 1 ms was assumed, and a rule needed it
  std::optional<configuration::FileError> unreadable;    ///< the input itself could not be read: exit status 2
  std::vector<std::string> files;         ///< every file that was read, in order (for dependency files)
};

/// `path` ends in .json and holds an object: a machine file; in .nc: an NC program alone, of which no machine comes;
/// else one axis list. `sources` receives every
/// text read, of NC programs only the lines that findings can point at (see whole_programs). The machine may read programs again, so `files` must
/// live as long as it. Never throws for bad input.
[[nodiscard]] CheckResult check(configuration::Files& files, std::string const& path, CheckOptions const& options,
                                SourceSet& sources);
/// The same for who needs one finding at a time: nothing holds them together in memory.
[[nodiscard]] CheckResult check(configuration::Files& files, std::string const& path, CheckOptions const& options,
                                SourceSet& sources, FindingSink const& sink);

}  // namespace axisc::validator
