// The one call that most users of this folder need: sources in, findings and (when there is no error) a
// machine out.
#pragma once

#include "configuration/files.hpp"
#include "configuration/machine/machine.hpp"
#include "diagnostics/finding.hpp"
#include "validator/not_compiled.hpp"
#include "validator/options.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::validator {

/// The reason why an input makes no machine.
enum class Obstacle : std::uint8_t {
  none,
  /// Something that it names is missing, unreadable or of another kind, or it is itself not understood.
  incomplete,
  errors,
  no_axis
};

struct CheckResult {
  std::vector<Finding> findings;  ///< in output order; empty if a sink takes them
  /// Present only if wanted and possible; findings that prevent it count even where they are not shown.
  std::optional<machine::Machine> machine;
  /// The input is a list of another kind than axis lists (AX7001): it does not describe a machine.
  bool is_other_list = false;
  bool is_update_of_axis = false;         ///< such a list that is an axis list in XML: it holds only changes
  Obstacle obstacle = Obstacle::none;     ///< why there is no machine
  std::vector<NotCompiled> not_compiled;  ///< configured features that `machine` does not contain
  bool cycle_time_known = false;          ///< the options or the machine file set it
  bool cycle_time_assumed = false;        ///< 1 ms was assumed, and a rule needed it
  std::optional<configuration::FileError> unreadable;  ///< the input itself could not be read: exit status 2
  std::vector<std::string> files;  ///< every file that was read, in order (for dependency files)
};

/// Checks a machine file if `path` ends in .json and the file contains an object, an NC program (without a
/// machine) if it ends in .nc, else one axis list. `sources` receives every text read; of NC programs only
/// the lines that findings can point to (see whole_programs). The machine may read programs again, so `files`
/// must outlive it. Never throws for bad input.
[[nodiscard]] CheckResult check(configuration::Files& files, std::string const& path,
                                CheckOptions const& options, SourceSet& sources);
struct LoadedMachine;
/// Checks an input that load() has read; the machine stays the caller's.
[[nodiscard]] CheckResult check(LoadedMachine& machine, configuration::Files& files,
                                CheckOptions const& options, SourceSet& sources, FindingSink const& sink);
/// As check() above, but passes one finding at a time to `sink` instead of collecting them in memory.
[[nodiscard]] CheckResult check(configuration::Files& files, std::string const& path,
                                CheckOptions const& options, SourceSet& sources, FindingSink const& sink);

}  // namespace axisc::validator
