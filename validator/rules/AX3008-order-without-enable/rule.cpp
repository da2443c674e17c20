#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void order_without_enable(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.unusable() || !filter.standard_type) return;
  if (filter.enable.value.flag() || !filter.order.set() || filter.order.value.number <= 0) return;
  Finding& finding = report.add(
      filter.order,
      {Text::ax3008, {{"filter", filter_name(filter)}, {"order", number(filter.order.value.number)}}});
  finding.label = Message{Text::ax3008_label, {{"enable", parameter_name(filter.enable)}}};
  if (filter.enable.value_place()) {
    finding.related.push_back({*filter.enable.value_place(), {Text::ax3008_enable_here, {}}});
  }
  finding.help.push_back({Text::ax3008_help, {{"enable", parameter_name(filter.enable)}}});
  react(finding, {Text::filter_reaction_inactive, {}});
}

}  // namespace

extern constinit Rule const ax3008{
    .code = Code{3008},
    .name = "order-without-enable",
    .severity = Severity::note,
    .check = order_without_enable,
};

}  // namespace axisc::validator::checks
