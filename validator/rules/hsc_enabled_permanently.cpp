#include "validator/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/kernel_checks.hpp"

namespace axisc::validator::checks {

void hsc_enabled_permanently(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!is_configured_hsc(filter) || filter.enable.unusable || !filter.enable.value.flag()) return;
  Finding& finding = report.add(filter.enable, {Text::ax3011, {{"filter", filter_name(filter)}}});
  finding.label = Message{Text::ax3011_label, {}};
  if (filter.prototype.value_place()) {
    finding.related.push_back({*filter.prototype.value_place(), {Text::ax3010_prototype_here, {}}});
  }
  if (filter.enable.value_place() && !filter.enable.referenced) {
    finding.fix = Fix{.title = {Text::ax3011_fix, {{"enable", parameter_name(filter.enable)}}},
                      .edits = {{*filter.enable.value_place(), "0"}},
                      .safety = FixSafety::changes_behaviour};
  }
  react(finding, "110629", {Text::ax3011_reaction, {}});
}

}  // namespace axisc::validator::checks
