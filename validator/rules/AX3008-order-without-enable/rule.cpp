#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/sentences.hpp"

namespace axisc::validator::checks::ax3008::says {

constexpr Sentence headline{"`{filter}` has order {order}, but is not enabled",
                            "`{filter}` hat die Ordnung {order}, ist aber nicht eingeschaltet"};
constexpr Sentence label{"has no effect while `{enable}` is 0", "ohne Wirkung, solange `{enable}` 0 ist"};
constexpr Sentence enable_here{"the filter is switched off here", "hier wird der Filter ausgeschaltet"};
constexpr Sentence help{"`{enable} 1` switches the filter on", "`{enable} 1` schaltet den Filter ein"};

}  // namespace axisc::validator::checks::ax3008::says

namespace axisc::validator::checks::ax3008 {
namespace {

void order_without_enable(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.unusable() || !filter.standard_type) return;
  if (filter.enable.value.flag() || !filter.order.set() || filter.order.value.number <= 0) return;
  Finding& finding = report.add(
      filter.order,
      {says::headline, {{"filter", filter_name(filter)}, {"order", number(filter.order.value.number)}}});
  finding.label = Message{says::label, {{"enable", parameter_name(filter.enable)}}};
  if (filter.enable.value_place()) {
    finding.related.push_back({*filter.enable.value_place(), {says::enable_here, {}}});
  }
  finding.help.push_back({says::help, {{"enable", parameter_name(filter.enable)}}});
  react(finding, {validator::says::filter_reaction_inactive, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "filters[].order filters[].enable",
    .check = order_without_enable,
};

}  // namespace axisc::validator::checks::ax3008
