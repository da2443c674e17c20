#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/reference_words.hpp"

namespace axisc::validator::checks {
namespace {

void reference_unresolvable(AxisContext const& context, Report& report) {
  for_each_problem(context, ReferenceTrouble::unresolvable,
                   [&](ReferenceProblem const& problem, EffectiveValue const& value) {
                     Message const text =
                         problem.target
                             ? message(Text::ax2010_no_value, {{"name", name_of(context, *problem.target)},
                                                               {"p_axis", named(problem)}})
                             : message(Text::ax2010, {{"p_axis", named(problem)}});
                     keep_earlier(context, report.add(value, text), value);
                   });
}

}  // namespace

extern constinit Rule const ax2010{
    .code = Code{2010},
    .name = "reference-unresolvable",
    .control = "2052",
    .check = reference_unresolvable,
};

}  // namespace axisc::validator::checks
