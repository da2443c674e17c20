#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax2017::says {

constexpr Sentence headline{
    "no list gives the axis \"{axis}\" a velocity or an acceleration limit",
    "keine Liste gibt der Achse „{axis}“ eine Geschwindigkeits- oder Beschleunigungsgrenze"};
constexpr Sentence standard{"{p_axis}: `{parameter}` has its default, {value}",
                            "{p_axis}: `{parameter}` hat seinen Standardwert {value}"};
constexpr Sentence help{"set `vb_max` and `a_max` of the axis", "`vb_max` und `a_max` der Achse setzen"};

}  // namespace axisc::validator::checks::ax2017::says

namespace axisc::validator::checks::ax2017 {
namespace {

void limits_not_set(AxisContext const& axis, Report& report) {
  // A list that is linted alone may be an excerpt.
  EffectiveValue const& anchor = axis.values.at("kopf.achs_nr");
  if (!axis.machine.machine_file || anchor.origin != Origin::axis_list) return;
  EffectiveValue const& velocity = axis.values.at("getriebe[].dynamik.vb_max");
  EffectiveValue const& acceleration = axis.values.at("getriebe[].dynamik.a_max");
  bool const any = velocity.set() || velocity.unusable || acceleration.set() || acceleration.unusable;
  if (any) return;
  Finding& finding = report.add(anchor, {says::headline, {{"axis", axis.name}}});
  for (EffectiveValue const* const value : {&velocity, &acceleration}) {
    finding.notes.push_back({says::standard,
                             {{"p_axis", parameter_number(*value)},
                              {"parameter", parameter_name(*value)},
                              {"value", number(value->value.number)}}});
  }
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "getriebe[].dynamik.a_max getriebe[].dynamik.vb_max kopf.achs_nr",
    .check = limits_not_set,
};

}  // namespace axisc::validator::checks::ax2017
