#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void fir_delay_share(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (fir.configured_type() != FirType::time_delay || fir.share.unusable) return;
  double const share = fir.share.value.number;
  if (share == 0 || share == 100) return;
  Finding& finding = report.add(fir.anchor(fir.share), {Text::ax3025, {{"share", number(share)}}});
  finding.label = Message{Text::ax3025_label, {{"share", number(share)}, {"rest", number(100 - share)}}};
  relate_set_type(finding, fir.type);
  finding.help.push_back({Text::ax3025_help, {}});
}

}  // namespace

extern constinit Rule const ax3025{
    .code = Code{3025},
    .name = "fir-delay-share",
    .severity = Severity::warning,
    .check = fir_delay_share,
};

}  // namespace axisc::validator::checks
