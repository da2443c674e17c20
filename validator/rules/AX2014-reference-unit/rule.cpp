#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/reference_words.hpp"
#include "validator/views/units_text.hpp"

namespace axisc::validator::checks::ax2014::says {

constexpr Sentence headline{"`{parameter}` is in {unit}, but {p_axis} is in {other}",
                            "`{parameter}` hat die Einheit {unit}, {p_axis} aber {other}"};
constexpr Sentence reaction{"it takes the number as it is", "sie übernimmt die Zahl unverändert"};
constexpr Sentence help{"refer to a parameter of the same unit, or write the value itself",
                        "auf einen Parameter gleicher Einheit verweisen, oder den Wert selbst schreiben"};

}  // namespace axisc::validator::checks::ax2014::says

namespace axisc::validator::checks::ax2014 {
namespace {

void reference_unit(AxisContext const& context, Report& report) {
  for_each_problem(
      context, ReferenceTrouble::other_unit,
      [&](ReferenceProblem const& problem, EffectiveValue const& value) {
        Finding& finding = report.add(
            value,
            message(says::headline,
                    {{"parameter", name_of(context, problem.slot)},
                     {"unit", raw_unit_name(unit_of(context.values.row(problem.slot), context.type))},
                     {"p_axis", named(problem)},
                     {"other", raw_unit_name(unit_of(context.values.row(*problem.target), context.type))}}));
        set_reaction(finding, says::reaction);
        finding.help.push_back(message(says::help));
        add_target(context, finding, problem);
      });
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = "2049",
    .precedence = Precedence::after_text,
    .check = reference_unit,
};

}  // namespace axisc::validator::checks::ax2014
