#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/reference_words.hpp"

namespace axisc::validator::checks::ax2011::says {

constexpr Sentence itself{"`{parameter}` refers to itself", "`{parameter}` verweist auf sich selbst"};
constexpr Sentence circle{"`{parameter}` refers to itself in a circle",
                          "`{parameter}` verweist im Kreis auf sich selbst"};
constexpr Sentence member{"`{parameter}` belongs to the circle", "`{parameter}` gehört zum Kreis"};
constexpr Sentence help{"give one of the parameters a number", "einem der Parameter eine Zahl geben"};

}  // namespace axisc::validator::checks::ax2011::says

namespace axisc::validator::checks::ax2011 {
namespace {

void reference_circular(AxisContext const& context, Report& report) {
  for_each_problem(
      context, ReferenceTrouble::circular, [&](ReferenceProblem const& problem, EffectiveValue const& value) {
        SentenceRef const text = problem.circle.empty() ? says::itself : says::circle;
        Finding& finding = report.add(value, message(text, {{"parameter", name_of(context, problem.slot)}}));
        keep_earlier(context, finding, value);
        finding.help.push_back(message(says::help));
        for (schema::Slot const member : problem.circle) {
          finding.related.push_back(
              {.place = *context.values[member].value_place(),
               .message = message(says::member, {{"parameter", name_of(context, member)}})});
        }
      });
}

}  // namespace

extern constinit Rule const rule{
    .control = "2051",
    .check = reference_circular,
};

}  // namespace axisc::validator::checks::ax2011
