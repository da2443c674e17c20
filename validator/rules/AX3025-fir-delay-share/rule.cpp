#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks::ax3025::says {

constexpr Sentence headline{
    "a time delay with a share of {share} % mixes in the undelayed signal",
    "eine Zeitverzögerung mit {share} % Signalanteil mischt unverzögertes Signal bei"};
constexpr Sentence label{"{share} % delayed, {rest} % undelayed",
                         "{share} % verzögert, {rest} % unverzögert"};
constexpr Sentence help{"100 delays the whole signal", "100 verzögert das ganze Signal"};

}  // namespace axisc::validator::checks::ax3025::says

namespace axisc::validator::checks::ax3025 {
namespace {

void fir_delay_share(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (fir.configured_type() != FirType::time_delay || fir.share.unusable) return;
  double const share = fir.share.value.number;
  if (share == 0 || share == 100) return;
  Finding& finding = report.add(fir.anchor(fir.share), {says::headline, {{"share", number(share)}}});
  finding.label = Message{says::label, {{"share", number(share)}, {"rest", number(100 - share)}}};
  relate_set_type(finding, fir.type);
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filter_fir.share filter_fir.type",
    .check = fir_delay_share,
};

}  // namespace axisc::validator::checks::ax3025
