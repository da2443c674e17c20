// Findings about what the grammar could not read.
#pragma once

#include "validator/engine/rule.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator::checks {

/// A finding for each problem of a kind; `describe(finding, context, problem)` makes its text.
template <auto describe>
void report_problems(ListContext const& context, grammar::ProblemKind kind, Report& report) {
  for (grammar::Problem const& problem : context.list.tree.problems) {
    if (problem.kind != kind) continue;
    report.later(place_of(context, problem.span),
                 [&context, &problem](Finding& finding) { describe(finding, context, problem); });
  }
}

}  // namespace axisc::validator::checks
