#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/views/fir_view.hpp"

namespace axisc::validator::checks::ax4006::says {

constexpr Sentence headline{"an axis cannot have both a FIR filter and the Vibration Guard",
                            "eine Achse kann nicht zugleich einen FIR-Filter und den Vibration Guard haben"};
constexpr Sentence guard_here{"the Vibration Guard is switched on here",
                              "hier wird der Vibration Guard eingeschaltet"};
constexpr Sentence reaction{"the Vibration Guard is not active", "der Vibration Guard ist nicht aktiv"};
constexpr Sentence help{"set `{type}` or `{guard}` to 0", "`{type}` oder `{guard}` auf 0 setzen"};

}  // namespace axisc::validator::checks::ax4006::says

namespace axisc::validator::checks::ax4006 {
namespace {

bool guards(EffectiveValue const& active) {
  return active.is_on();
}

void fir_with_vibration_guard(AxisContext const& axis, Report& report) {
  FirView const& fir = axis.fir;
  EffectiveValue const& guard = axis.values.at("vib_guard.active");
  if (!fir.configured() || !guards(guard)) return;
  Finding& finding = report.add(fir.type, {says::headline, {}});
  if (guard.value_place()) {
    finding.related.push_back({*guard.value_place(), {says::guard_here, {}}});
  }
  finding.help.push_back(
      {says::help, {{"type", parameter_name(fir.type)}, {"guard", parameter_name(guard)}}});
  react(finding, {says::reaction, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = "110630",
    .parameters = "filter_fir.type vib_guard.active",
    .check = fir_with_vibration_guard,
};

}  // namespace axisc::validator::checks::ax4006
