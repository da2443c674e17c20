#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"
#include "validator/sentences.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax5003::says {

constexpr Sentence headline{"#FILTER and #VIB GUARD must not be used in the same NC program",
                            "#FILTER und #VIB GUARD dürfen nicht im selben NC-Programm vorkommen"};
constexpr Sentence help{
    "both smooth the setpoints: FIR filters over a wide band, the Vibration Guard at one frequency; keep one "
    "of them",
    "beide glätten die Sollwerte: FIR-Filter breitbandig, der Vibration Guard bei einer Frequenz; nur eines "
    "von beiden verwenden"};

}  // namespace axisc::validator::checks::ax5003::says

namespace axisc::validator::checks::ax5003 {
namespace {

void filter_and_vibration_guard(ProgramContext const& context, Report& report) {
  using grammar::CommandKind;
  auto const& commands = context.program.tree.commands;
  auto const has = [&commands](CommandKind kind) {
    return std::any_of(commands.begin(), commands.end(),
                       [kind](grammar::NcCommand const& command) { return command.kind == kind; });
  };
  if (!has(CommandKind::filter) || !has(CommandKind::vibration_guard)) return;
  std::vector<Span> const spans = commands_where(context, [](grammar::NcCommand const& command) {
    return command.kind == CommandKind::filter || command.kind == CommandKind::vibration_guard;
  });
  Finding& finding = report_at_last(context, report, spans, message(says::headline));
  finding.help.push_back(message(says::help));
  set_reaction(finding, validator::says::program_reaction_aborted);
}

}  // namespace

extern constinit Rule const rule{
    .control = "22060",
    .check = filter_and_vibration_guard,
};

}  // namespace axisc::validator::checks::ax5003
