// What a check is asked to do: everything about policy comes in here, as data.
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
  std::optional<machine::AxisType> axis_type;   ///< overrides kenngr.achs_typ of a list
  design::Readings readings;                    ///< what the control makes of its filters
  std::optional<BuildVersion> build;            ///< of the control: what it does not know yet is AX2016
  bool pedantic = false;                        ///< notes as well
  std::vector<Code> disabled;
  /// Instead of those of the rules: what is an error here keeps the machine from being made, and hides warnings.
  std::map<Code, Severity> severities;
  std::vector<PathRule> paths;  ///< each is compared with the file in which a finding is, not with the input
  bool whole_programs = false;  ///< keep all of an NC program, so that fixes can be applied to it
  bool machine = true;          ///< make the machine; who only wants findings need not pay for it
  schema::Catalogue catalogue;  ///< of the parameters that axis lists may set
  std::optional<schema::ListKind> kind;  ///< of the input, where it is a list; none: found out
  bool from_folder = false;              ///< the input was found in a folder, nobody named it
  bool is_beside_start_up_list = false;  ///< the same, and a start-up list there does not name it
};

/// Takes the findings of one input in output order, each as soon as it has words. It may change them and move out of them.
using FindingSink = std::function<void(Finding&)>;

}  // namespace axisc::validator
