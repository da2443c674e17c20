#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/sentences.hpp"

namespace axisc::validator::checks::ax3007::says {

constexpr Sentence headline{"`{filter}` is enabled, but its order is 0: it is not active",
                            "`{filter}` ist eingeschaltet, aber seine Ordnung ist 0: er ist nicht aktiv"};
constexpr Sentence label{"has no effect with order 0", "bei Ordnung 0 ohne Wirkung"};
constexpr Sentence label_default{"has no effect: no list sets `{parameter}`, which is 0 by default",
                                 "ohne Wirkung: keine Liste setzt `{parameter}`, der Standardwert ist 0"};
constexpr Sentence order_here{"the order is 0 here", "hier ist die Ordnung 0"};
constexpr Sentence limit{
    "{enable_number}: a filter is active with enable = 1 and order > 0 ({order_number})",
    "{enable_number}: ein Filter ist aktiv mit enable = 1 und order > 0 ({order_number})"};
constexpr Sentence help{"set `{order}` to at least 1, or `{enable}` to 0",
                        "`{order}` auf mindestens 1 setzen, oder `{enable}` auf 0"};

}  // namespace axisc::validator::checks::ax3007::says

namespace axisc::validator::checks::ax3007 {
namespace {

void enabled_without_order(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.unusable() || !filter.standard_type) return;
  if (!filter.enable.value.flag() || filter.order.value.number > 0) return;
  Finding& finding = report.add(filter.enable, {says::headline, {{"filter", filter_name(filter)}}});
  if (filter.order.value_place()) {
    finding.label = Message{says::label, {}};
    finding.related.push_back({*filter.order.value_place(), {says::order_here, {}}});
  } else {
    finding.label = Message{says::label_default, {{"parameter", parameter_name(filter.order)}}};
  }
  finding.notes.push_back({says::limit,
                           {{"enable_number", parameter_number(filter.enable)},
                            {"order_number", parameter_number(filter.order)}}});
  finding.help.push_back(
      {says::help, {{"order", parameter_name(filter.order)}, {"enable", parameter_name(filter.enable)}}});
  react(finding, {validator::says::filter_reaction_inactive, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filters[].order filters[].enable",
    .check = enabled_without_order,
};

}  // namespace axisc::validator::checks::ax3007
