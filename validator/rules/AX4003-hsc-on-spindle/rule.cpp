#include "validator/engine/rule.hpp"

#include "validator/views/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void hsc_on_spindle(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!is_configured_hsc(filter) || context.axis.type != machine::AxisType::spindle) return;
  Finding& finding = report.add(filter.prototype, {Text::ax4003, {{"filter", filter_name(filter)}}});
  finding.notes.push_back({Text::ax4003_limit, {}});
}

}  // namespace

extern constinit Rule const ax4003{
    .code = Code{4003},
    .name = "hsc-on-spindle",
    .check = hsc_on_spindle,
};

}  // namespace axisc::validator::checks
