#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"

namespace axisc::validator::checks::ax3040::says {

constexpr Sentence headline{
    "the filter of the additional interface is enabled with its invalid defaults: `PT2` and 0 µs",
    "der Filter der Zusatzschnittstelle ist mit ungültigen Standardwerten eingeschaltet: `PT2` und 0 µs"};
constexpr Sentence label{"0 µs is shorter than any NC cycle", "0 µs ist kürzer als jeder NC-Zyklus"};
constexpr Sentence limit{"{p_axis}: time_constant ≥ T for `PT1` and `PT2`",
                         "{p_axis}: time_constant ≥ T für `PT1` und `PT2`"};
constexpr Sentence help{"set `{time_constant}`, or choose another `{type}`",
                        "`{time_constant}` setzen, oder einen anderen `{type}` wählen"};

}  // namespace axisc::validator::checks::ax3040::says

namespace axisc::validator::checks::ax3040 {
namespace {

void interface_filter_invalid_default(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.port != FilterPort::additional_interface || !filter.active()) return;
  EffectiveValue const& time = filter.time_constant;
  if (time.unusable || time.value.number != 0) return;
  if (filter.standard_type != design::FilterType::pt2) return;
  Finding& finding = report.add(filter.anchor(time), {says::headline, {}});
  finding.label = Message{says::label, {}};
  finding.notes.push_back({says::limit, {{"p_axis", parameter_number(time)}}});
  note_default(finding, time);
  finding.help.push_back(
      {says::help, {{"time_constant", parameter_name(time)}, {"type", parameter_name(filter.type)}}});
  react(finding, {validator::says::filter_reaction_off, {}});
}

}  // namespace

extern constinit Rule const rule{
    .control = "70451",
    .parameters =
        "lr_param.add_interface.filter[].time_constant lr_param.add_interface.filter[].type "
        "lr_param.add_interface.filter[].enable lr_param.add_interface.filter[].order",
    .check = interface_filter_invalid_default,
};

}  // namespace axisc::validator::checks::ax3040
