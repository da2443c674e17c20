#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

namespace axisc::validator::checks::ax1008::says {

constexpr Sentence headline{"text after `Ende` is ignored", "Text nach `Ende` wird nicht mehr gelesen"};
constexpr Sentence related{"the list ends here", "hier endet die Liste"};
constexpr Sentence help{
    "if it belongs to the list, remove this `Ende`; else remove it or make it a comment",
    "gehört er zur Liste, dieses `Ende` entfernen; sonst ihn entfernen oder zum Kommentar machen"};

}  // namespace axisc::validator::checks::ax1008::says

namespace axisc::validator::checks::ax1008 {
namespace {

void describe(Finding& finding, ListContext const& context, grammar::Problem const& /*problem*/) {
  finding.message = message(says::headline);
  if (auto const& marker = context.list.tree.end_marker) {
    finding.related.push_back({.place = place_of(context, *marker), .message = message(says::related)});
  }
  finding.help.push_back(message(says::help));
}

void text_after_end(ListContext const& context, Report& report) {
  report_problems<describe>(context, grammar::ProblemKind::text_after_end, report);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .check = text_after_end,
};

}  // namespace axisc::validator::checks::ax1008
