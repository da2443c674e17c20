#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void enabled_without_order(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.unusable() || !filter.standard_type) return;
  if (!filter.enable.value.flag() || filter.order.value.number > 0) return;
  Finding& finding = report.add(filter.enable, {Text::ax3007, {{"filter", filter_name(filter)}}});
  if (filter.order.value_place()) {
    finding.label = Message{Text::ax3007_label, {}};
    finding.related.push_back({*filter.order.value_place(), {Text::ax3007_order_here, {}}});
  } else {
    finding.label = Message{Text::ax3007_label_default, {{"parameter", parameter_name(filter.order)}}};
  }
  finding.notes.push_back({Text::ax3007_limit,
                           {{"enable_number", parameter_number(filter.enable)},
                            {"order_number", parameter_number(filter.order)}}});
  finding.help.push_back(
      {Text::ax3007_help,
       {{"order", parameter_name(filter.order)}, {"enable", parameter_name(filter.enable)}}});
  react(finding, {Text::filter_reaction_inactive, {}});
}

}  // namespace

extern constinit Rule const ax3007{
    .code = Code{3007},
    .name = "enabled-without-order",
    .severity = Severity::warning,
    .check = enabled_without_order,
};

}  // namespace axisc::validator::checks
