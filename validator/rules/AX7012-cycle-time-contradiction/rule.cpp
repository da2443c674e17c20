#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax7012::says {

constexpr Sentence headline{"the real-time list says {list}, checked was with {used}",
                            "die Echtzeitliste sagt {list}, geprüft wurde mit {used}"};
constexpr Sentence in_project{"the task in the project has {list}, checked was with {used}",
                              "der Task im Projekt hat {list}, geprüft wurde mit {used}"};
constexpr Sentence note{"the option or the settings win over the list",
                        "die Option oder die Einstellungen gehen der Liste vor"};
constexpr Sentence help{"leave out the cycle time, and the list's counts",
                        "die Zykluszeit weglassen, dann gilt die der Liste"};

}  // namespace axisc::validator::checks::ax7012::says

namespace axisc::validator::checks::ax7012 {
namespace {

void cycle_time_contradiction(MachineContext const& context, Report& report) {
  LoadedMachine const& machine = context.machine;
  if (!machine.start_up || !machine.start_up->real_time.cycle_time || !machine.cycle_time) return;
  configuration::RealTimeList const& real_time = machine.start_up->real_time;
  if (*real_time.cycle_time == *machine.cycle_time) return;
  SentenceRef const headline = machine.start_up->is_project ? says::in_project : says::headline;
  Finding& finding =
      report.add(real_time.place, {headline,
                                   {{"list", microseconds(real_time.cycle_time->microseconds())},
                                    {"used", microseconds(machine.cycle_time->microseconds())}}});
  finding.notes.push_back({says::note, {}});
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .check = cycle_time_contradiction,
};

}  // namespace axisc::validator::checks::ax7012
