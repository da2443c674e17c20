#include "validator/rules/program_helpers.hpp"

#include <algorithm>
#include <utility>

namespace axisc::validator::says {

constexpr Sentence here_too{"the same applies here", "dasselbe gilt hier"};

}  // namespace axisc::validator::says

namespace axisc::validator {
namespace {

/// More related places than these do not help.
constexpr std::size_t most_related = 20;

}  // namespace

bool is_fir_filter(ProgramContext const& context, grammar::NcCommand const& command) {
  return command.kind == grammar::CommandKind::filter && !means_hsc(command, context.text);
}

bool is_fir_filter_on(ProgramContext const& context, grammar::NcCommand const& command) {
  return is_fir_filter(context, command) && command.command_switch == grammar::CommandSwitch::on;
}

Finding& report_at_last(ProgramContext const& context, Report& report, std::vector<Span> const& spans,
                        Message message) {
  SourceId const source = context.program.source;
  Finding& finding = report.add(Place{.source = source, .span = spans.back()}, std::move(message));
  std::size_t const others = spans.size() - 1;
  for (std::size_t i = others - std::min(others, most_related); i < others; ++i) {
    finding.related.push_back({.place = {.source = source, .span = spans[i]}, .message = {says::here_too}});
  }
  return finding;
}

std::string names_of(std::vector<LoadedAxis const*> const& axes) {
  std::string names;
  for (LoadedAxis const* const axis : axes) names.append(names.empty() ? "" : ", ").append(axis->name);
  return names;
}

void set_axis(Finding& finding, std::vector<LoadedAxis const*> const& axes) {
  if (axes.size() == 1) finding.axis = axes.front()->name;
}

void relate_values(Finding& finding, std::vector<LoadedAxis const*> const& axes, std::string_view pattern,
                   SentenceRef text) {
  for (LoadedAxis const* const axis : axes) {
    EffectiveValue const& value = axis->merged.values.at(pattern);
    if (!value.value_place()) continue;
    finding.related.push_back({.place = *value.value_place(), .message = {text, {{"axis", axis->name}}}});
  }
}

}  // namespace axisc::validator
