// Checks one input with the settings that apply to it.
#pragma once

#include "axisc/checking/checked_input.hpp"
#include "axisc/workspace/workspace.hpp"
#include "validator/check.hpp"

#include <string>

namespace axisc {

struct JudgedInput {
  FindingCounts counts;           ///< of the wanted findings
  validator::CheckResult result;  ///< the rest
};

// The functions below may be called by several threads. They throw errors that end the whole run.

/// Every wanted finding is passed to `take` as soon as it is known. `checked` receives the sources, the files
/// and the failure.
[[nodiscard]] JudgedInput judge_input(Workspace& workspace, std::string const& path, CheckedInput& checked,
                                      TakeFinding const& take);
/// For callers that need only the findings: they are passed to `take`, or, where it is null, part of the
/// result.
[[nodiscard]] CheckedInput check_input(Workspace& workspace, std::string const& path,
                                       TakeFinding const* take);

}  // namespace axisc
