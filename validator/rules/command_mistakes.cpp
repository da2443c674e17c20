#include "validator/rules/command_mistakes.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/sentences.hpp"

namespace axisc::validator::says {

constexpr Sentence program_fix{"write `{replacement}`", "`{replacement}` schreiben"};

constexpr Sentence first{"first here", "zuerst hier"};

}  // namespace axisc::validator::says

namespace axisc::validator {

void report_mistakes(CommandContext const& context, Code code, Report& report) {
  for (CommandMistake const& mistake : context.checked.mistakes) {
    if (mistake.code != code) continue;
    Place const place = context.place(mistake.span);
    Finding& finding = report.add(place, mistake.message);
    finding.label = mistake.label;
    finding.notes = mistake.notes;
    finding.help = mistake.help;
    if (mistake.depends_on_cycle_time && !context.whole.machine.cycle_time) {
      finding.notes.push_back(message(says::cycle_time_assumed_note));
    }
    if (mistake.first) {
      finding.related.push_back({.place = context.place(*mistake.first), .message = message(says::first)});
    }
    if (mistake.better && !context.instead) {
      finding.fix =
          replace_by(place, *mistake.better, message(says::program_fix, {{"replacement", *mistake.better}}));
    }
    finding.control.reset();
    if (mistake.reaction) {
      finding.control = ControlReaction{
          .message = mistake.control, .reaction = message(*mistake.reaction), .value = mistake.value};
    }
  }
}

}  // namespace axisc::validator
