#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/hsc_view.hpp"

namespace axisc::validator::checks::ax4001::says {

constexpr Sentence headline{"the HSC filter `{filter}` must be `filter[0]`",
                            "der HSC-Filter `{filter}` muss `filter[0]` sein"};
constexpr Sentence label{"HSC filters work only as the first filter",
                         "HSC-Filter wirken nur als erster Filter"};
constexpr Sentence help{"make it `filter[0]`, and number the others after it",
                        "ihn zu `filter[0]` machen, und die anderen dahinter zählen"};

}  // namespace axisc::validator::checks::ax4001::says

namespace axisc::validator::checks::ax4001 {
namespace {

void hsc_not_first(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!is_configured_hsc(filter) || filter.index == 0) return;
  Finding& finding = report.add(filter.prototype, {says::headline, {{"filter", filter_name(filter)}}});
  finding.label = Message{says::label, {}};
  finding.help.push_back({says::help, {}});
  react(finding, {validator::says::filter_reaction_off, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = "110501",
    .parameters = "filter[].prototype filter[].type filter[].order",
    .silenced_by = codes<4002>,
    .check = hsc_not_first,
};

}  // namespace axisc::validator::checks::ax4001
