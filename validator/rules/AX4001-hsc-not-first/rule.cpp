#include "validator/engine/rule.hpp"

#include "validator/views/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void hsc_not_first(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!is_configured_hsc(filter) || filter.index == 0) return;
  Finding& finding = report.add(filter.prototype, {Text::ax4001, {{"filter", filter_name(filter)}}});
  finding.label = Message{Text::ax4001_label, {}};
  react(finding, {Text::filter_reaction_off, {}});
}

}  // namespace

extern constinit Rule const ax4001{
    .code = Code{4001},
    .name = "hsc-not-first",
    .control = "110501",
    .silenced_by = codes<4002>,
    .check = hsc_not_first,
};

}  // namespace axisc::validator::checks
