#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

#include <algorithm>

namespace axisc::validator::checks {
namespace {

void delay_not_last(FilterContext const& context, Report& report) {
  FilterView const& delay = context.filter;
  bool const is_delay = delay.standard_type == design::FilterType::time_delay;
  if (delay.port != FilterPort::setpoint || !delay.active() || !is_delay) return;
  auto const filters = context.axis.filters;
  auto const next = std::find_if(filters.begin(), filters.end(), [&](FilterView const& filter) {
    return filter.port == FilterPort::setpoint && filter.index > delay.index && filter.active();
  });
  if (next == filters.end()) return;
  Finding& finding =
      report.add(delay.anchor(delay.type),
                 {Text::ax4004, {{"filter", filter_name(delay)}, {"next", filter_name(*next)}}});
  finding.notes.push_back({Text::ax4004_limit, {}});
  react(finding, {Text::ax4004_reaction, {}});
  if (next->enable.value_place()) {
    finding.related.push_back(
        {*next->enable.value_place(), {Text::ax4004_next_here, {{"filter", filter_name(*next)}}}});
  }
}

}  // namespace

extern constinit Rule const ax4004{
    .code = Code{4004},
    .name = "delay-not-last",
    .control = "110583",
    .check = delay_not_last,
};

}  // namespace axisc::validator::checks
