#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/hsc_view.hpp"

namespace axisc::validator::checks::ax4003::says {

constexpr Sentence headline{"the HSC filter `{filter}` is configured for a spindle",
                            "der HSC-Filter `{filter}` ist für eine Spindel konfiguriert"};
constexpr Sentence limit{"spindles have standard filters only", "für Spindeln gibt es nur Standardfilter"};
constexpr Sentence help{"use a standard filter, or a FIR filter (`filter_fir`)",
                        "einen Standardfilter oder einen FIR-Filter (`filter_fir`) verwenden"};

}  // namespace axisc::validator::checks::ax4003::says

namespace axisc::validator::checks::ax4003 {
namespace {

void hsc_on_spindle(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!is_configured_hsc(filter) || context.axis.type != machine::AxisType::spindle) return;
  Finding& finding = report.add(filter.prototype, {says::headline, {{"filter", filter_name(filter)}}});
  finding.notes.push_back({says::limit, {}});
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .parameters = "filter[].prototype filter[].type kenngr.achs_typ",
    .check = hsc_on_spindle,
};

}  // namespace axisc::validator::checks::ax4003
