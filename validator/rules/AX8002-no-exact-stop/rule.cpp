#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/motion_blocks.hpp"
#include "validator/rules/program_helpers.hpp"

namespace axisc::validator::checks::ax8002::says {

constexpr Sentence no_stop{"`G09` does not stop here; `G60` does", "`G09` hält hier nicht; `G60` hält"};
constexpr Sentence what_it_does{
    "G09 says that the path has slowed down to the next feed by the end of the block while G901 is on; "
    "without G901 that is always so",
    "G09 bestimmt, dass die Bahn am Ende des Satzes auf den nächsten Vorschub gebremst hat, während G901 "
    "wirkt; ohne G901 ist das immer so"};
constexpr Sentence no_motion{"`G60` stands in a block without motion",
                             "`G60` steht in einem Satz ohne Bewegung"};
constexpr Sentence no_motion_help{
    "write it in the block whose end is to be the stop; `G360` stops at every block",
    "in den Satz schreiben, an dessen Ende gehalten werden soll; `G360` hält an "
    "jedem Satz"};
constexpr Sentence reaction{"it aborts the program", "sie bricht das Programm ab"};

}  // namespace axisc::validator::checks::ax8002::says

namespace axisc::validator::checks::ax8002 {
namespace {

void report_stop_without_motion(ProgramContext const& context, Span span, Report& report) {
  Finding& finding =
      report.add(Place{.source = context.program.source, .span = span}, message(says::no_motion));
  finding.severity = Severity::error;
  finding.help.push_back(message(says::no_motion_help));
  set_reaction(finding, says::reaction);
  finding.control->message = "20003";
}

void no_exact_stop(ProgramContext const& context, Report& report) {
  std::vector<Span> without_effect;
  bool brakes_late = false;
  for (grammar::WantedBlock const& wanted : context.program.tree.blocks) {
    MotionBlock const block(wanted, context.text);
    auto const functions = block.functions();
    for (BlockFunction const& function : functions) {
      if (function.number == 901) brakes_late = true;
      if (function.number == 900) brakes_late = false;
      if (function.number == 60 && !block.moves()) report_stop_without_motion(context, function.span, report);
    }
    for (BlockFunction const& function : functions) {
      if (function.number == 9 && !brakes_late) without_effect.push_back(function.span);
    }
  }
  if (without_effect.empty()) return;
  Finding& finding = report_at_last(context, report, without_effect, message(says::no_stop));
  finding.notes.push_back(message(says::what_it_does));
  finding.control.reset();
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = "20003",
    .check = no_exact_stop,
};

}  // namespace axisc::validator::checks::ax8002
