#include "validator/engine/rule.hpp"

#include "validator/views/hsc_view.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

namespace axisc::validator::checks {
namespace {

void hsc_without_preconfiguration(ProgramContext const& context, Report& report) {
  if (context.group == nullptr) return;
  auto const with_hsc =
      axes_where(context, [](EffectiveValues const& values) { return !configured_hsc(values).empty(); });
  if (!with_hsc.empty()) return;
  std::vector<Span> spans;
  for (grammar::NcCommand const& command : context.program.tree.commands) {
    bool const on =
        command.kind == grammar::CommandKind::filter && command.command_switch == grammar::CommandSwitch::on;
    grammar::Keyword const* const keyword = on ? find_keyword(command, context.text, "HSC") : nullptr;
    if (keyword != nullptr) spans.push_back(keyword->name);
  }
  if (spans.empty()) return;
  Finding& finding = report_at_last(context, report, spans, message(Text::ax5010));
  finding.help.push_back(message(Text::ax5010_help));
  set_reaction(finding, Text::filter_reaction_inactive);
}

}  // namespace

extern constinit Rule const ax5010{
    .code = Code{5010},
    .name = "hsc-without-preconfiguration",
    .check = hsc_without_preconfiguration,
};

}  // namespace axisc::validator::checks
