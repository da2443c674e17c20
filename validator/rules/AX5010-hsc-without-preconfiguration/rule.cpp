#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"
#include "validator/sentences.hpp"
#include "validator/views/hsc_view.hpp"

namespace axisc::validator::checks::ax5010::says {

constexpr Sentence headline{"#FILTER ON [HSC] has no HSC filter to switch on",
                            "#FILTER ON [HSC] findet keinen HSC-Filter zum Einschalten"};
constexpr Sentence help{
    "preconfigure `filter[0].prototype HSC` in all axes of the channel, with the same values",
    "`filter[0].prototype HSC` in allen Achsen des Kanals gleich vorkonfigurieren"};

}  // namespace axisc::validator::checks::ax5010::says

namespace axisc::validator::checks::ax5010 {
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
  Finding& finding = report_at_last(context, report, spans, message(says::headline));
  finding.help.push_back(message(says::help));
  set_reaction(finding, validator::says::filter_reaction_inactive);
}

}  // namespace

extern constinit Rule const rule{
    .parameters = "filter[].prototype filter[].type filter[].order",
    .check = hsc_without_preconfiguration,
};

}  // namespace axisc::validator::checks::ax5010
