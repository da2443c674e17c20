// Helpers of the rules about references: values that name another parameter, "P-AXIS-00212.0".
#pragma once

#include "validator/engine/rule.hpp"

#include <string>

namespace axisc::validator::checks {

/// Calls `visit(problem, value)` for the values whose reference has this trouble.
template <typename Visit>
void for_each_problem(AxisContext const& context, ReferenceTrouble trouble, Visit visit) {
  for (ReferenceProblem const& problem : context.reference_problems) {
    if (problem.trouble == trouble) visit(problem, context.values[problem.slot]);
  }
}

/// "P-AXIS-00212" as the reference names it, even if no such number exists.
[[nodiscard]] std::string named(ReferenceProblem const& problem);

/// The parameter in `slot`, with its index.
[[nodiscard]] std::string name_of(AxisContext const& context, schema::Slot slot);

/// The control continues with the value of the default list, or with the documented default; the value is
/// omitted if it is unknown.
void keep_earlier(AxisContext const& context, Finding& finding, EffectiveValue const& value);

/// Names the parameter that the reference leads to, and points to its value if a list sets it.
void add_target(AxisContext const& context, Finding& finding, ReferenceProblem const& problem);

}  // namespace axisc::validator::checks
