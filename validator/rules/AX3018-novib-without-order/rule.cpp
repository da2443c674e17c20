#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/hsc_view.hpp"

namespace axisc::validator::checks::ax3018::says {

constexpr Sentence headline{"the HSC NoVib filter `{filter}` has order 0: it is never active",
                            "der HSC-NoVib-Filter `{filter}` hat die Ordnung 0: er wirkt nie"};
constexpr Sentence limit{"{p_axis}: NoVib computes its order itself, but is active only with order > 0",
                         "{p_axis}: NoVib berechnet seine Ordnung selbst, ist aber nur mit order > 0 aktiv"};
constexpr Sentence help{"`{parameter} 1` activates it", "`{parameter} 1` aktiviert ihn"};

}  // namespace axisc::validator::checks::ax3018::says

namespace axisc::validator::checks::ax3018 {
namespace {

void novib_without_order(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (hsc_type(filter) != HscType::novib || filter.order.unusable || filter.order.value.number > 0) return;
  Finding& finding =
      report.add(filter.anchor(filter.order), {says::headline, {{"filter", filter_name(filter)}}});
  finding.notes.push_back({says::limit, {{"p_axis", parameter_number(filter.order)}}});
  note_default(finding, filter.order);
  finding.help.push_back({says::help, {{"parameter", parameter_name(filter.order)}}});
  react(finding, {validator::says::kernel_reaction_not_active, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filter[].order filter[].type filter[].prototype",
    .check = novib_without_order,
};

}  // namespace axisc::validator::checks::ax3018
