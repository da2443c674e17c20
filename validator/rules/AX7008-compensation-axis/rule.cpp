#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax7008::says {

constexpr Sentence headline{
    "the compensation list is for axis {own}, the start-up list gives it to axis {number}",
    "die Kompensationsliste gilt für Achse {own}, die Hochlaufliste ordnet sie Achse {number} zu"};
constexpr Sentence own_here{"the list names its axis here", "hier nennt die Liste ihre Achse"};
constexpr Sentence reaction{"it refuses the compensation list", "sie weist die Kompensationsliste zurück"};
constexpr Sentence help{"correct the number that is wrong", "die falsche Nummer berichtigen"};

}  // namespace axisc::validator::checks::ax7008::says

namespace axisc::validator::checks::ax7008 {
namespace {

void compensation_axis(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  for (StartUpCompensation const& compensation : context.machine.start_up->compensations) {
    auto const& given = compensation.entry.axis;
    auto const& own = compensation.own_axis;
    if (!given || !own || given->number == own->number) continue;
    Finding& finding = report.add(
        given->place,
        {says::headline, {{"own", std::to_string(own->number)}, {"number", std::to_string(given->number)}}});
    finding.related.push_back({own->place, {says::own_here, {}}});
    finding.help.push_back({says::help, {}});
    react(finding, {says::reaction, {}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = "110229",
    .parameters = "kopf.achs_nr",
    .check = compensation_axis,
};

}  // namespace axisc::validator::checks::ax7008
