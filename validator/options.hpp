// The options of a check: everything about policy comes in here, as data.
#pragma once

#include "configuration/machine/machine.hpp"
#include "design/readings.hpp"
#include "design/units.hpp"
#include "diagnostics/finding.hpp"
#include "schema/catalogue.hpp"
#include "validator/loading/build_version.hpp"

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
  std::optional<design::CycleTime> cycle_time_otherwise = {};  ///< where the input says none
  std::optional<machine::AxisType> axis_type;                  ///< overrides kenngr.achs_typ of a list
  design::Readings readings;                                   ///< how the control computes its filters
  machine::MotionReadings motion;                              ///< how the control plans a path
  std::optional<BuildVersion> build;                           ///< of the control: newer features are AX2016
  bool pedantic = false;                                       ///< notes as well
  std::vector<Code> disabled;
  /// Instead of those of the rules: a finding that is an error here prevents the machine and hides warnings.
  std::map<Code, Severity> severities;
  std::vector<PathRule> paths;  ///< each is compared with the file in which a finding is, not with the input
  bool whole_programs = false;  ///< keep all of an NC program, so that fixes can be applied to it
  bool machine = true;          ///< make the machine; callers that only want findings save the time
  schema::Catalogue catalogue;  ///< of the parameters that axis lists may set
  std::optional<schema::ListKind> kind;  ///< of the input, where it is a list; none: found out
  bool from_folder = false;              ///< the input was found in a folder, not named
  bool is_beside_start_up_list = false;  ///< found in a folder with a start-up list that does not name it
};

/// Takes the findings of one input in output order, each as soon as its text is made. It may change them and
/// move out of them.
using FindingSink = std::function<void(Finding&)>;

}  // namespace axisc::validator
