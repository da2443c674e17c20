#include "validator/engine/rule.hpp"

#include "validator/views/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/hsc_words.hpp"

namespace axisc::validator::checks {
namespace {

void hsc_enabled_permanently(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!is_configured_hsc(filter) || filter.enable.unusable || !filter.enable.value.flag()) return;
  Finding& finding = report.add(filter.enable, {Text::ax3011, {{"filter", filter_name(filter)}}});
  finding.label = Message{Text::ax3011_label, {}};
  relate_prototype(finding, filter);
  if (filter.enable.value_place() && !filter.enable.referenced) {
    finding.fix = Fix{.title = {Text::ax3011_fix, {{"enable", parameter_name(filter.enable)}}},
                      .edits = {{*filter.enable.value_place(), "0"}},
                      .safety = FixSafety::changes_behaviour};
  }
  react(finding, {Text::ax3011_reaction, {}});
}

}  // namespace

extern constinit Rule const ax3011{
    .code = Code{3011},
    .name = "hsc-enabled-permanently",
    .control = "110629",
    .check = hsc_enabled_permanently,
};

}  // namespace axisc::validator::checks
