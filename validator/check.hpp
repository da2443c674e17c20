// The one call that most users of this folder need: sources in, findings and (when there is no error) a
// machine out.
#pragma once

#include "configuration/files.hpp"
#include "design/units.hpp"
#include "diagnostics/finding.hpp"
#include "machine/machine.hpp"
#include "schema/catalogue.hpp"
#include "validator/loading/build_version.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace axisc::validator {

/// Codes that are disabled in some files.
struct PathRule {
  std::function<bool(std::string const& file)> covers;  ///< takes the file name as findings show it
  std::vector<Code> disabled;
};

struct CheckOptions {
  std::optional<design::CycleTime> cycle_time;  ///< from the command line; overrides that of a machine file
  std::optional<machine::AxisType> axis_type;   ///< overrides kenngr.achs_typ of a list
  std::optional<BuildVersion> build;            ///< of the control: newer features are reported as AX2016
  bool pedantic = false;                        ///< report notes, too
  std::vector<Code> disabled;
  /// Overrides the severities of the rules: with an error no machine is built, and errors hide warnings on the same
  /// token.
  std::map<Code, Severity> severities;
  std::vector<PathRule> paths;  ///< each applies to the file that contains the finding, not to the input
  bool whole_programs = false;  ///< keep all of an NC program, so that fixes can be applied to it
  bool machine = true;          ///< build the machine; false saves the cost if only findings are wanted
  schema::Catalogue catalogue;  ///< of the parameters that the lists may set
};

/// A feature that a list configures and that an image cannot hold yet; `compile` refuses then.
struct NotCompiled {
  Place place;
  Message feature;  ///< "the FIR filter of axis X"
};

/// Takes the findings of one input in output order, each as soon as its text is made. It may change findings and move
/// them away.
using FindingSink = std::function<void(Finding&)>;

struct CheckResult {
  std::vector<Finding> findings;  ///< in output order; empty if a sink takes them
  /// Present only if wanted, without errors, not for an NC program, and not for a machine file that is only partly
  /// understood, even if AX4020 is silenced.
  std::optional<machine::Machine> machine;
  std::vector<NotCompiled> not_compiled;  ///< configured features that `machine` does not contain
  bool cycle_time_known = false;          ///< the options or the machine file set it
  bool cycle_time_assumed = false;        ///< 1 ms was assumed, and a rule needed it
  std::optional<configuration::FileError> unreadable;  ///< the input itself could not be read: exit status 2
  std::vector<std::string> files;  ///< every file that was read, in order (for dependency files)
};

/// Checks a machine file if `path` ends in .json and the file contains an object, an NC program (without a machine) if
/// it ends in .nc, else one axis list. `sources` receives every text read; of NC programs only the lines that findings
/// can point to (see whole_programs). The machine may read programs again, so `files` must outlive it. Never throws for
/// bad input.
[[nodiscard]] CheckResult check(configuration::Files& files, std::string const& path,
                                CheckOptions const& options, SourceSet& sources);
/// As check() above, but passes one finding at a time to `sink` instead of collecting them in memory.
[[nodiscard]] CheckResult check(configuration::Files& files, std::string const& path,
                                CheckOptions const& options, SourceSet& sources, FindingSink const& sink);

}  // namespace axisc::validator
