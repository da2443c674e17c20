#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax7013::says {

constexpr Sentence headline{R"(programs call this axis "{name}", its list calls it "{own}")",
                            "Programme nennen diese Achse „{name}“, ihre Liste nennt sie „{own}“"};
constexpr Sentence note{
    "programs use the name of the channel list (P-CHAN-00006); messages of the control may use the other",
    "Programme verwenden den Namen der Kanalliste (P-CHAN-00006); Meldungen der Steuerung können den anderen "
    "nennen"};
constexpr Sentence own_here{"the list says so here", "hier sagt es die Liste"};
constexpr Sentence help{"if the difference is not meant, change one of the names",
                        "ist der Unterschied nicht gewollt, einen der Namen ändern"};

}  // namespace axisc::validator::checks::ax7013::says

namespace axisc::validator::checks::ax7013 {
namespace {

void name_contradiction(MachineContext const& context, Report& report) {
  LoadedMachine const& machine = context.machine;
  if (!machine.start_up) return;
  for (StartUpChannel const& channel : machine.start_up->channels) {
    for (configuration::ChannelAxis const& named : channel.list.axes) {
      auto const axis = axis_numbered(machine, named.number->number);
      if (!axis || !named.name) continue;
      EffectiveValue const& own = machine.axes[*axis].merged.values.at("kopf.log_achs_name");
      bool const differs = own.set() && !own.unusable && own.value.text != named.name->text;
      if (!differs || own.origin != Origin::axis_list || !own.value_place()) continue;
      report.axis = machine.axes[*axis].name;
      Finding& finding =
          report.add(named.name->place,
                     {says::headline, {{"name", named.name->text}, {"own", std::string(own.value.text)}}});
      finding.related.push_back({*own.value_place(), {says::own_here, {}}});
      finding.notes.push_back({says::note, {}});
      finding.help.push_back({says::help, {}});
    }
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "kopf.log_achs_name kopf.achs_nr",
    .check = name_contradiction,
};

}  // namespace axisc::validator::checks::ax7013
