// Runs the table of rules over lists, axes, filters, channels and programs, and decides which findings stand.
#pragma once

#include "validator/check.hpp"
#include "validator/loading.hpp"
#include "validator/rule.hpp"

namespace axisc::validator {

struct EngineResult {
  bool has_errors = false;          ///< among what stands
  bool cycle_time_assumed = false;  ///< nothing gives it, and a rule that needs it looked at something
};

/// Every rule over everything that was loaded; `loading` is what was found on the way. What stands is told to `sink` in
/// output order, AX9006 first. Cost: one pass of each rule over what it looks at, plus sorting.
EngineResult run_rules(LoadedMachine const& machine, ReportedFindings loading, CheckOptions const& options,
                       SourceSet const& sources, FindingSink const& sink);

}  // namespace axisc::validator
