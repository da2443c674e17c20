// Runs the table of rules over lists, axes, filters, channels and programs, and decides which findings are
// kept.
#pragma once

#include "validator/engine/rule.hpp"
#include "validator/loading/loading.hpp"
#include "validator/options.hpp"
#include "validator/views/axis_views.hpp"

#include <deque>

namespace axisc::validator {

struct EngineResult {
  bool has_errors = false;          ///< among the findings that are kept
  bool cycle_time_assumed = false;  ///< it is not known, and a rule that needs it had something to check
};

/// Runs every rule over everything that was loaded, and adds the findings of loading; `views` has one entry
/// per axis, and may be empty if a default list is missing. The findings that are kept go to `sink` in output
/// order, AX9006 first. Cost: one pass of each rule over what it checks, plus sorting.
EngineResult run_rules(LoadedMachine const& machine, std::deque<AxisViews> const& views,
                       CheckOptions const& options, SourceSet const& sources, FindingSink const& sink);

}  // namespace axisc::validator
