#include "validator/engine/rule.hpp"

#include "validator/views/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void novib_without_order(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (hsc_type(filter) != HscType::novib || filter.order.unusable || filter.order.value.number > 0) return;
  Finding& finding =
      report.add(filter.anchor(filter.order), {Text::ax3018, {{"filter", filter_name(filter)}}});
  finding.notes.push_back({Text::ax3018_limit, {{"p_axis", parameter_number(filter.order)}}});
  note_default(finding, filter.order);
  finding.help.push_back({Text::ax3018_help, {{"parameter", parameter_name(filter.order)}}});
  react(finding, {Text::kernel_reaction_not_active, {}});
}

}  // namespace

extern constinit Rule const ax3018{
    .code = Code{3018},
    .name = "novib-without-order",
    .severity = Severity::warning,
    .check = novib_without_order,
};

}  // namespace axisc::validator::checks
