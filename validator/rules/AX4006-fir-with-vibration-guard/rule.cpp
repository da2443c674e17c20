#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

bool guards(EffectiveValue const& active) {
  return !active.unusable && active.value.flag();
}

void fir_with_vibration_guard(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  EffectiveValue const& guard = axis.values.at("vib_guard.active");
  if (!fir.configured() || !guards(guard)) return;
  Finding& finding = report.add(fir.type, {Text::ax4006, {}});
  if (guard.value_place()) {
    finding.related.push_back({*guard.value_place(), {Text::ax4006_guard_here, {}}});
  }
  react(finding, {Text::ax4006_reaction, {}});
}

}  // namespace

extern constinit Rule const ax4006{
    .code = Code{4006},
    .name = "fir-with-vibration-guard",
    .control = "110630",
    .check = fir_with_vibration_guard,
};

}  // namespace axisc::validator::checks
