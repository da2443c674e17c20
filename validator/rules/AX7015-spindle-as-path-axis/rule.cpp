#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax7015::says {

constexpr Sentence headline{"the spindle \"{axis}\" is listed among the path axes",
                            "die Spindel „{axis}“ steht bei den Bahnachsen"};
constexpr Sentence type_here{"its type is set here", "hier wird ihr Typ gesetzt"};
constexpr Sentence help{"list it in `spindel[i]`", "sie in `spindel[i]` aufführen"};

}  // namespace axisc::validator::checks::ax7015::says

namespace axisc::validator::checks::ax7015 {
namespace {

void spindle_as_path_axis(MachineContext const& context, Report& report) {
  LoadedMachine const& machine = context.machine;
  if (!machine.start_up) return;
  for (StartUpChannel const& channel : machine.start_up->channels) {
    for (configuration::ChannelAxis const& named : channel.list.axes) {
      auto const axis = axis_numbered(machine, named.number->number);
      if (!axis || machine.axes[*axis].type != machine::AxisType::spindle) continue;
      report.axis = machine.axes[*axis].name;
      Finding& finding =
          report.add(named.number->place, {says::headline, {{"axis", machine.axes[*axis].name}}});
      EffectiveValue const& type = machine.axes[*axis].merged.values.at("kenngr.achs_typ");
      if (type.value_place()) finding.related.push_back({*type.value_place(), {says::type_here, {}}});
      finding.help.push_back({says::help, {}});
    }
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "kopf.achs_nr kenngr.achs_typ",
    .check = spindle_as_path_axis,
};

}  // namespace axisc::validator::checks::ax7015
