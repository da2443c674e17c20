// AX4001 to AX4003 and AX4007: where an HSC filter may stand, and what replaces it.
#include "validator/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/kernel_checks.hpp"

#include <algorithm>
#include <tuple>

namespace axisc::validator::checks {
namespace {

/// The prototype that makes it an HSC filter is always set by a list.
bool stands_before(FilterView const& left, FilterView const& right) {
  return std::tuple(left.prototype.origin, left.prototype.line) <
         std::tuple(right.prototype.origin, right.prototype.line);
}

}  // namespace

void hsc_not_first(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!is_configured_hsc(filter) || filter.index == 0) return;
  Finding& finding = report.add(filter.prototype, {Text::ax4001, {{"filter", filter_name(filter)}}});
  finding.label = Message{Text::ax4001_label, {}};
  react(finding, "110501", {Text::filter_reaction_off, {}});
}

void hsc_more_than_one(FilterContext const& context, Report& report) {
  if (!is_configured_hsc(context.filter)) return;
  std::vector<FilterView> const filters = configured_hsc(context.axis.filters);
  auto const last = std::max_element(filters.begin(), filters.end(), stands_before);
  if (filters.size() < 2 || last->index != context.filter.index) return;
  Finding& finding =
      report.add(last->prototype, {Text::ax4002, {{"count", number(static_cast<double>(filters.size()))}}});
  finding.label = Message{Text::ax4002_label, {}};
  for (FilterView const& filter : filters) {
    if (filter.index == last->index || !filter.prototype.value_place()) continue;
    finding.related.push_back(
        {*filter.prototype.value_place(), {Text::ax4002_filter_here, {{"filter", filter_name(filter)}}}});
  }
  react(finding, "110500", {Text::filter_reaction_off, {}});
}

void hsc_on_spindle(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!is_configured_hsc(filter) || context.axis.type != AxisType::spindle) return;
  Finding& finding = report.add(filter.prototype, {Text::ax4003, {{"filter", filter_name(filter)}}});
  finding.notes.push_back({Text::ax4003_limit, {}});
}

void hsc_superseded(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  auto const& build = context.axis.machine.build;
  if (!is_configured_hsc(filter) || (build && *build < builds::fir_command)) return;
  Finding& finding = report.add(filter.prototype, {Text::ax4007, {{"filter", filter_name(filter)}}});
  finding.help.push_back({Text::ax4007_help, {}});
}

}  // namespace axisc::validator::checks
