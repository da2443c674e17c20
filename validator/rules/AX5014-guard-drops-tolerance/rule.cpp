#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

#include <string>

namespace axisc::validator::checks::ax5014::says {

constexpr Sentence dropped{"this command ends the tolerance monitoring: it does not name AX_DEV",
                           "dieser Befehl beendet die Toleranzüberwachung: er nennt AX_DEV nicht"};
constexpr Sentence begun{"AX_DEV was set here", "hier wurde AX_DEV gesetzt"};
constexpr Sentence name_it{"`AX_DEV={value}` keeps it", "mit `AX_DEV={value}` bleibt sie"};

}  // namespace axisc::validator::checks::ax5014::says

namespace axisc::validator::checks::ax5014 {
namespace {

void guard_drops_tolerance(ProgramContext const& context, Report& report) {
  grammar::NcCommand const* monitored = nullptr;
  std::string tolerance;
  bool reported = false;
  for (grammar::NcCommand const& command : context.program.tree.commands) {
    if (command.kind != grammar::CommandKind::vibration_guard) continue;
    grammar::Keyword const* const named = find_keyword(command, context.text, "AX_DEV");
    bool const off = command.command_switch == grammar::CommandSwitch::off;
    if (!off && named == nullptr && monitored != nullptr && !reported) {
      reported = true;
      Finding& finding =
          report.add({.source = context.program.source, .span = command.name}, message(says::dropped));
      finding.related.push_back(
          {{.source = context.program.source, .span = monitored->name}, message(says::begun)});
      finding.help.push_back(message(says::name_it, {{"value", tolerance}}));
    }
    monitored = nullptr;
    if (off || named == nullptr) continue;
    tolerance = std::string(context.text.substr(named->value.begin, named->value.size()));
    bool const is_zero = tolerance.find_first_not_of("0.") == std::string::npos;
    if (!is_zero) monitored = &command;
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .check = guard_drops_tolerance,
};

}  // namespace axisc::validator::checks::ax5014
