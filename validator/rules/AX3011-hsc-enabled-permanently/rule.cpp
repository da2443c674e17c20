#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/hsc_words.hpp"
#include "validator/views/hsc_view.hpp"

namespace axisc::validator::checks::ax3011::says {

constexpr Sentence headline{"the HSC filter `{filter}` cannot be switched on by the list",
                            "der HSC-Filter `{filter}` lässt sich nicht durch die Liste einschalten"};
constexpr Sentence label{"HSC filters are switched on by `#FILTER ON [HSC]`",
                         "HSC-Filter schaltet `#FILTER ON [HSC]` ein"};
constexpr Sentence fix{"set `{enable}` to 0", "`{enable}` auf 0 setzen"};
constexpr Sentence reaction{"the filter is not switched on permanently",
                            "der Filter wird nicht dauerhaft eingeschaltet"};

}  // namespace axisc::validator::checks::ax3011::says

namespace axisc::validator::checks::ax3011 {
namespace {

void hsc_enabled_permanently(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!is_configured_hsc(filter) || !filter.enable.is_on()) return;
  Finding& finding = report.add(filter.enable, {says::headline, {{"filter", filter_name(filter)}}});
  finding.label = Message{says::label, {}};
  relate_prototype(finding, filter);
  if (filter.enable.value_place() && !filter.enable.referenced) {
    finding.fix = Fix{.title = {says::fix, {{"enable", parameter_name(filter.enable)}}},
                      .edits = {{*filter.enable.value_place(), "0"}},
                      .safety = FixSafety::changes_behaviour};
  }
  react(finding, {says::reaction, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = "110629",
    .parameters = "filters[].enable filters[].prototype",
    .check = hsc_enabled_permanently,
};

}  // namespace axisc::validator::checks::ax3011
