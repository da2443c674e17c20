#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks::ax3020::says {

constexpr Sentence headline{"the FIR filter is enabled, but has no type: it is not active",
                            "der FIR-Filter ist eingeschaltet, hat aber keinen Typ: er ist nicht aktiv"};
constexpr Sentence types{"{p_axis}: 1 moving average, 2 Gaussian, 3 windowed sinc, 4 time delay",
                         "{p_axis}: 1 gleitender Mittelwert, 2 Gauß, 3 Windowed Sinc, 4 Zeitverzögerung"};
constexpr Sentence help{"set `filter_fir.type`, or `filter_fir.enable` to 0",
                        "`filter_fir.type` setzen, oder `filter_fir.enable` auf 0"};

}  // namespace axisc::validator::checks::ax3020::says

namespace axisc::validator::checks::ax3020 {
namespace {

void fir_without_type(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  if (fir.enable.unusable || fir.type.unusable) return;
  if (!fir.enable.value.flag() || fir.type.value.number != 0) return;
  Finding& finding = report.add(fir.anchor(fir.type), {says::headline, {}});
  finding.notes.push_back({says::types, {{"p_axis", parameter_number(fir.type)}}});
  note_default(finding, fir.type);
  finding.help.push_back({says::help, {}});
  react(finding, {validator::says::kernel_reaction_not_active, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = "110634/51043",
    .parameters = "filter_fir.type filter_fir.enable",
    .check = fir_without_type,
};

}  // namespace axisc::validator::checks::ax3020
