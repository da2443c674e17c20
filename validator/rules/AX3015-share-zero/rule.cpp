#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/filter_words.hpp"

#include <string>

namespace axisc::validator::checks {
namespace {

bool works(FilterView const& filter) {
  return filter.active() || (filter.is_hsc() && filter.port == FilterPort::setpoint);
}

void check(EffectiveValue const& share, std::string filter, EffectiveValue const& enable, Report& report) {
  if (share.unusable || share.value.number != 0) return;
  Finding& finding = report.add(share, {Text::ax3015, {{"filter", std::move(filter)}}});
  finding.label = Message{Text::ax3015_label, {}};
  finding.notes.push_back({Text::ax3015_limit, {{"p_axis", parameter_number(share)}}});
  if (enable.value.flag()) finding.help.push_back({Text::ax3015_help, {{"enable", parameter_name(enable)}}});
  react(finding, {Text::filter_reaction_inactive, {}});
}

void share_zero(AxisContext const& axis, Report& report) {
  for (FilterView const& filter : axis.filters) {
    if (works(filter)) check(filter.share, filter_name(filter), filter.enable, report);
  }
  FirView const& fir = axis.fir;
  if (fir.configured()) check(fir.share, "filter_fir", fir.enable, report);
}

}  // namespace

extern constinit Rule const ax3015{
    .code = Code{3015},
    .name = "share-zero",
    .severity = Severity::warning,
    .check = share_zero,
};

}  // namespace axisc::validator::checks
