#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/reference_words.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"there is no parameter {p_axis}", "einen Parameter {p_axis} gibt es nicht"};
constexpr Sentence no_value{
    "`{name}` ({p_axis}) has no value: no list sets it, and it has no default",
    "`{name}` ({p_axis}) hat keinen Wert: keine Liste setzt ihn, und er hat keinen Standardwert"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

void reference_unresolvable(AxisContext const& context, Report& report) {
  for_each_problem(context, ReferenceTrouble::unresolvable,
                   [&](ReferenceProblem const& problem, EffectiveValue const& value) {
                     Message const text =
                         problem.target
                             ? message(says::no_value, {{"name", name_of(context, *problem.target)},
                                                        {"p_axis", named(problem)}})
                             : message(says::headline, {{"p_axis", named(problem)}});
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
