#include "validator/engine/rule.hpp"

#include "validator/views/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void hsc_superseded(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  auto const& build = context.axis.machine.build;
  if (!is_configured_hsc(filter) || (build && *build < builds::fir_command)) return;
  Finding& finding = report.add(filter.prototype, {Text::ax4007, {{"filter", filter_name(filter)}}});
  finding.help.push_back({Text::ax4007_help, {}});
}

}  // namespace

extern constinit Rule const ax4007{
    .code = Code{4007},
    .name = "hsc-superseded",
    .severity = Severity::note,
    .check = hsc_superseded,
};

}  // namespace axisc::validator::checks
