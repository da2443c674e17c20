#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

#include <string>

namespace axisc::validator::checks::ax3019::says {

constexpr Sentence headline{"share {share} %: `{filter}` changes next to nothing",
                            "Signalanteil {share} %: `{filter}` ändert fast nichts"};
constexpr Sentence limit{"{p_axis}: the share is in percent; 100 is the whole signal",
                         "{p_axis}: der Signalanteil ist in Prozent; 100 ist das ganze Signal"};
constexpr Sentence help{"100 was meant, if 1 stood for the whole",
                        "100 war gemeint, wenn 1 für das Ganze steht"};

}  // namespace axisc::validator::checks::ax3019::says

namespace axisc::validator::checks::ax3019 {
namespace {

constexpr double tiny = 1;  // percent

void check(EffectiveValue const& share, std::string filter, Report& report) {
  if (share.unusable || !(share.value.number > 0 && share.value.number <= tiny)) return;
  Finding& finding = report.add(
      share, {says::headline, {{"filter", std::move(filter)}, {"share", number(share.value.number)}}});
  finding.notes.push_back({says::limit, {{"p_axis", parameter_number(share)}}});
  finding.help.push_back({says::help, {}});
}

void tiny_share(AxisContext const& axis, Report& report) {
  for (FilterView const& filter : axis.filters) {
    if (filter.active()) check(filter.share, filter_name(filter), report);
  }
  if (axis.fir.configured()) check(axis.fir.share, "filter_fir", report);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters =
        "filters[].share_percent filters[].enable filters[].order filters[].type filter_fir.share "
        "filter_fir.type",
    .check = tiny_share,
};

}  // namespace axisc::validator::checks::ax3019
