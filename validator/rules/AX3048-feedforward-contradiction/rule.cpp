#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/feedforward_view.hpp"

#include <string_view>

namespace axisc::validator::checks::ax3048::says {

constexpr Sentence disabled{"feedforward is disabled, but P-AXIS-00223 names {value}",
                            "die Vorsteuerung ist gesperrt, aber P-AXIS-00223 nennt {value}"};
constexpr Sentence empty{
    "feedforward is active from the start, but P-AXIS-00223 names nothing to feed forward",
    "die Vorsteuerung ist von Anfang an aktiv, aber P-AXIS-00223 nennt nichts, was vorzusteuern ist"};
constexpr Sentence help_disabled{"set `{parameter}` to 0, or P-AXIS-00223 to NONE",
                                 "`{parameter}` auf 0 setzen, oder P-AXIS-00223 auf NONE"};
constexpr Sentence help_empty{"set `{parameter}` to 0, or name VEL in P-AXIS-00223",
                              "`{parameter}` auf 0 setzen, oder VEL in P-AXIS-00223 nennen"};

}  // namespace axisc::validator::checks::ax3048::says

namespace axisc::validator::checks::ax3048 {
namespace {

constexpr std::string_view disabled_with_quantities = "110343";
constexpr std::string_view active_without_quantities = "110356";

void feedforward_contradiction(AxisContext const& axis, Report& report) {
  FeedforwardView const feedforward(axis.values);
  EffectiveValue const& disabled = axis.values.at("vorsteuer.global_disable");
  EffectiveValue const& active = axis.values.at("vorsteuer.default_active");
  EffectiveValue const& quantities = feedforward.quantities;
  if (quantities.unusable) return;
  if (disabled.is_on() && quantities.value.flag()) {
    Finding& finding = report.add(disabled, {says::disabled, {{"value", symbol_word(quantities)}}});
    finding.help.push_back({says::help_disabled, {{"parameter", parameter_name(disabled)}}});
    react(finding, disabled_with_quantities, {validator::says::undocumented_reaction});
  }
  if (active.is_on() && feedforward.is_none()) {
    Finding& finding = report.add(active, {says::empty, {}});
    finding.help.push_back({says::help_empty, {{"parameter", parameter_name(active)}}});
    react(finding, active_without_quantities, {validator::says::undocumented_reaction});
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<disabled_with_quantities, active_without_quantities>,
    .parameters = "vorsteuer.vorsteuerung vorsteuer.default_active vorsteuer.global_disable",
    .check = feedforward_contradiction,
};

}  // namespace axisc::validator::checks::ax3048
