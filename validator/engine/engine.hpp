// Runs the table of rules over lists, axes, filters, channels and programs, and decides which findings stand.
#pragma once

#include "validator/views/axis_views.hpp"
#include "validator/options.hpp"
#include "validator/loading/loading.hpp"
#include "validator/engine/rule.hpp"

#include <deque>

namespace axisc::validator {

struct EngineResult {
  bool has_errors = false;          ///< among what stands
  bool cycle_time_assumed = false;  ///< nothing gives it, and a rule that needs it looked at something
};

/// Every rule over everything that was loaded, besides what was found on the way; `views` has one entry per axis, and may be
/// empty where a default list is missing. What stands is told to `sink` in
/// output order, AX9006 first. Cost: one pass of each rule over what it looks at, plus sorting.
EngineResult run_rules(LoadedMachine const& machine, std::deque<AxisViews> const& views,
                       CheckOptions const& options, SourceSet const& sources,
                       FindingSink const& sink);

}  // namespace axisc::validator
