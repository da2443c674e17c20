// The one call that most users of this folder need: sources in, findings and (when there is no error) a
// machine out.
#pragma once

#include "design/units.hpp"
#include "diagnostics/finding.hpp"
#include "schema/catalogue.hpp"
#include "validator/loading/build_version.hpp"
#include "configuration/files.hpp"
#include "machine/machine.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace axisc::validator {

/// Codes that are not reported in some files.
struct PathRule {
  std::function<bool(std::string const& file)> covers;  ///< by the file's name, as findings show it
  std::vector<Code> disabled;
};

struct CheckOptions {
  std::optional<design::CycleTime> cycle_time;  ///< from the command line; wins over a machine file's
  std::optional<machine::AxisType> axis_type;            ///< overrides kenngr.achs_typ of a list
  std::optional<BuildVersion> build;            ///< of the control: what it does not know yet is AX2016
  bool pedantic = false;                        ///< notes as well
  std::vector<Code> disabled;
  /// Instead of those of the rules: what is an error here keeps the machine from being made, and hides warnings.
  std::map<Code, Severity> severities;
  std::vector<PathRule> paths;  ///< each is compared with the file in which a finding is, not with the input
  bool whole_programs = false;  ///< keep all of an NC program, so that fixes can be applied to it
  bool machine = true;          ///< make the machine; who only wants findings need not pay for it
  schema::Catalogue catalogue;  ///< of the parameters that the lists may set
};

/// A feature that a list configures and that an image cannot hold yet; `compile` refuses then.
struct NotCompiled {
  Place place;
  Message feature;  ///< "the FIR filter of axis X"
};

/// Takes the findings of one input in output order, each as soon as it has words. It may change them and move out of them.
using FindingSink = std::function<void(Finding&)>;

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
