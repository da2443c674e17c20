#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/hsc_view.hpp"

namespace axisc::validator::checks::ax4007::says {

constexpr Sentence headline{"the HSC filter `{filter}` belongs to an older generation",
                            "der HSC-Filter `{filter}` gehört zu einer älteren Generation"};
constexpr Sentence help{"from build V3.1.3075.02 FIR filters (`filter_fir`) are recommended instead",
                        "ab Stand V3.1.3075.02 werden stattdessen FIR-Filter (`filter_fir`) empfohlen"};

}  // namespace axisc::validator::checks::ax4007::says

namespace axisc::validator::checks::ax4007 {
namespace {

void hsc_superseded(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  auto const& build = context.axis.machine.build;
  if (!is_configured_hsc(filter) || (build && *build < builds::fir_command)) return;
  Finding& finding = report.add(filter.prototype, {says::headline, {{"filter", filter_name(filter)}}});
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "filter[].prototype filter[].type",
    .check = hsc_superseded,
};

}  // namespace axisc::validator::checks::ax4007
