// Findings about text that the grammar could not read.
#pragma once

#include "validator/engine/rule.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator::checks {

/// A finding; `describe(finding, context, problem)` makes its text.
template <auto describe>
void report_problem(ListContext const& context, grammar::Problem const& problem, Report& report) {
  report.later(place_of(context, problem.span),
               [&context, &problem](Finding& finding) { describe(finding, context, problem); });
}

/// A finding for each problem of a kind.
template <auto describe>
void report_problems(ListContext const& context, grammar::ProblemKind kind, Report& report) {
  for (grammar::Problem const& problem : context.list.tree.problems) {
    if (problem.kind == kind) report_problem<describe>(context, problem, report);
  }
}

}  // namespace axisc::validator::checks
