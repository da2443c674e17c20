#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

namespace axisc::validator::checks::ax5009::says {

constexpr Sentence headline{"`{command}` switches off the FIR filters that #FILTER ON switched on",
                            "`{command}` schaltet die FIR-Filter ab, die #FILTER ON eingeschaltet hat"};
constexpr Sentence on_here{"switched on here", "hier eingeschaltet"};
constexpr Sentence reaction{"from here on the FIR filters are off", "ab hier sind die FIR-Filter aus"};
constexpr Sentence help{
    "write `#FILTER ON` again after it; filters that the lists enable stay on",
    "danach noch einmal `#FILTER ON` schreiben; Filter, die die Listen einschalten, bleiben an"};

}  // namespace axisc::validator::checks::ax5009::says

namespace axisc::validator::checks::ax5009 {
namespace {

void axis_exchange_disables(ProgramContext const& context, Report& report) {
  // The last #FILTER ON with the exchanges after it; a later #FILTER makes them harmless.
  std::vector<Span> spans;
  for (grammar::NcCommand const& command : context.program.tree.commands) {
    if (is_fir_filter(context, command)) {
      spans.clear();
      if (command.command_switch == grammar::CommandSwitch::on) spans.push_back(command.name);
    } else if (command.kind == grammar::CommandKind::axis_exchange && !spans.empty()) {
      spans.push_back(command.name);
    }
  }
  if (spans.size() < 2) return;
  Span const switched_on = spans.front();
  spans.erase(spans.begin());
  std::string const name(context.text.substr(spans.back().begin, spans.back().size()));
  Finding& finding = report_at_last(context, report, spans, message(says::headline, {{"command", name}}));
  finding.related.insert(
      finding.related.begin(),
      {.place = {.source = context.program.source, .span = switched_on}, .message = message(says::on_here)});
  finding.help.push_back(message(says::help));
  set_reaction(finding, says::reaction);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .check = axis_exchange_disables,
};

}  // namespace axisc::validator::checks::ax5009
