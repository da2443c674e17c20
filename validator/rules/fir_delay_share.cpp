#include "validator/fir_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/kernel_checks.hpp"

namespace axisc::validator::checks {

void fir_delay_share(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (fir.configured_type() != FirType::time_delay || fir.share.unusable) return;
  double const share = fir.share.value.number;
  if (share == 0 || share == 100) return;
  Finding& finding = report.add(fir.anchor(fir.share), {Text::ax3025, {{"share", number(share)}}});
  finding.label = Message{Text::ax3025_label, {{"share", number(share)}, {"rest", number(100 - share)}}};
  if (fir.type.value_place()) {
    finding.related.push_back({*fir.type.value_place(), {Text::filter_type_here, {}}});
  }
  finding.help.push_back({Text::ax3025_help, {}});
}

}  // namespace axisc::validator::checks
