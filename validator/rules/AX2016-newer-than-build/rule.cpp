// AX2016: features newer than the build of the control.
#include "validator/engine/rule.hpp"

#include "validator/loading/build_version.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/program_helpers.hpp"

#include <algorithm>
#include <array>

namespace axisc::validator::checks::ax2016::says {

constexpr Sentence headline{"`{parameter}` needs build {needed} of the control, which has {build}",
                            "`{parameter}` braucht den Stand {needed} der Steuerung, sie hat {build}"};
constexpr Sentence time_delay{"`TIME_DELAY` exists from one of the builds {needed}; the control has {build}",
                              "`TIME_DELAY` gibt es ab einem der Stände {needed}; die Steuerung hat {build}"};
constexpr Sentence quotes{
    "a text in quotes needs build {needed} of the control, which has {build}",
    "ein Text in Anführungszeichen braucht den Stand {needed} der Steuerung, sie hat {build}"};
constexpr Sentence spindle{"filters for spindles need build {needed} of the control, which has {build}",
                           "Filter für Spindeln brauchen den Stand {needed} der Steuerung, sie hat {build}"};
constexpr Sentence help{"leave it out, or use a build that has it",
                        "es weglassen, oder einen Stand verwenden, der es kennt"};
constexpr Sentence help_spindle{"switch the filter off, or use a newer build",
                                "den Filter ausschalten, oder einen neueren Stand verwenden"};

}  // namespace axisc::validator::checks::ax2016::says

namespace axisc::validator::checks::ax2016 {
namespace {

struct Family {
  std::string_view prefix;
  BuildVersion since;
};

// The first matching row applies.
constexpr std::array<Family, 4> families = {{
    {.prefix = "filter_fir.quality", .since = builds::fir_quality},
    {.prefix = "filter_fir.", .since = builds::fir},
    {.prefix = "vib_guard.", .since = builds::fir},
    {.prefix = "lr_param.improved_position_control.", .since = builds::position_control},
}};

BuildVersion needed_for(schema::Parameter const& parameter) {
  if (auto const since = parse_build_version(parameter.since)) return *since;
  auto const* const family = std::find_if(families.begin(), families.end(), [&](Family const& candidate) {
    return parameter.name.substr(0, candidate.prefix.size()) == candidate.prefix;
  });
  return family == families.end() ? BuildVersion{} : family->since;
}

bool is_time_delay(schema::Parameter const& parameter, LineValue const& line_value) {
  constexpr double time_delay = 11;
  bool const is_type =
      parameter.name == "filter[].type" || parameter.name == "lr_param.add_interface.filter[].type";
  return is_type && line_value.status == ReadingStatus::value && line_value.value.number == time_delay;
}

/// The build that the line needs, if it is newer than that of the control; else empty.
std::string missing_build(schema::Parameter const& parameter, LineValue const& line_value,
                          BuildVersion const& build) {
  BuildVersion const needed = needed_for(parameter);
  if (build < needed) return to_text(needed);
  if (is_time_delay(parameter, line_value) && !builds::has_time_delay(build)) {
    return "V2.11.2013, V2.11.2803, V3.00.3013";
  }
  if (line_value.quoted && build < builds::quotes) return to_text(builds::quotes);
  return {};
}

SentenceRef headline(schema::Parameter const& parameter, LineValue const& line_value,
                     BuildVersion const& build) {
  if (build < needed_for(parameter)) return says::headline;
  return is_time_delay(parameter, line_value) ? says::time_delay : says::quotes;
}

void describe(Finding& finding, AxisContext const& context, LineValue const& line_value) {
  BuildVersion const& build = *context.machine.build;
  schema::Parameter const& parameter = *line_value.row;
  name_parameter(finding, parameter, line_value.slot);
  finding.message = message(headline(parameter, line_value, build),
                            {{"parameter", finding.parameter},
                             {"needed", missing_build(parameter, line_value, build)},
                             {"build", to_text(build)}});
  finding.help.push_back(message(says::help));
}

void check_spindle(AxisContext const& context, BuildVersion const& build, Report& report) {
  if (context.type != machine::AxisType::spindle || build >= builds::spindle_filters) return;
  for (FilterView const& filter : context.filters) {
    bool const on = !filter.enable.unusable && filter.enable.value.flag();
    if (filter.port != FilterPort::setpoint || !on) continue;
    report
        .add(filter.enable, message(says::spindle, {{"needed", to_text(builds::spindle_filters)},
                                                    {"build", to_text(build)}}))
        .help.push_back(message(says::help_spindle));
  }
}

/// `#FILTER OFF` switches off what the program switched on: only HSC filters if the program uses no FIR
/// filters.
bool meant_for_fir(ProgramContext const& context, grammar::NcCommand const& command) {
  if (!is_fir_filter(context, command)) return false;
  if (command.command_switch != grammar::CommandSwitch::off) return true;
  bool uses_hsc = false;
  for (grammar::NcCommand const& other : context.program.tree.commands) {
    if (other.kind != grammar::CommandKind::filter || other.command_switch == grammar::CommandSwitch::off) {
      continue;
    }
    if (is_fir_filter(context, other)) return true;
    uses_hsc = true;
  }
  return !uses_hsc;
}

void check_needed(ProgramContext const& context, Span span, BuildVersion const& needed, Report& report) {
  BuildVersion const& build = *context.whole.machine.build;
  if (build >= needed) return;
  std::string const written(context.text.substr(span.begin, span.size()));
  report
      .add(Place{.source = context.program.source, .span = span},
           message(says::headline,
                   {{"parameter", written}, {"needed", to_text(needed)}, {"build", to_text(build)}}))
      .help.push_back(message(says::help));
}

void newer_than_build(AxisContext const& context, Report& report) {
  if (!context.machine.build) return;
  BuildVersion const& build = *context.machine.build;
  for (LoadedList const* const list : lists_of(context)) {
    if (list == nullptr) continue;
    for (std::size_t i = 0; i < list->line_values.size(); ++i) {
      LineValue const line_value = list->line_values[i];
      if (!line_value.usable() || missing_build(*line_value.row, line_value, build).empty()) continue;
      Place const place{.source = list->source, .span = list->tree.assignments[i].value};
      report.later(
          place, [&context, list, i](Finding& finding) { describe(finding, context, list->line_values[i]); });
    }
  }
  check_spindle(context, build, report);
}

void commands_newer_than_build(ProgramContext const& context, Report& report) {
  if (!context.whole.machine.build) return;
  BuildVersion const& build = *context.whole.machine.build;
  for (grammar::NcCommand const& command : context.program.tree.commands) {
    if (command.kind == grammar::CommandKind::vibration_guard) {
      check_needed(context, command.name, builds::fir, report);
    } else if (meant_for_fir(context, command)) {
      check_needed(context, command.name, builds::fir_command, report);
      // A command unknown to the build is reported once.
      grammar::Keyword const* const quality = find_keyword(command, context.text, "QUALITY");
      if (quality == nullptr || build < builds::fir_command) continue;
      check_needed(context, quality->name, builds::fir_quality, report);
    }
  }
}

/// A string may be quoted, a filter type may be TIME_DELAY, and spindles may have no filters.
bool is_about(schema::Parameter const& parameter) {
  return BuildVersion{} < needed_for(parameter) || parameter.type == schema::DataType::string ||
         parameter.name == "filter[].enable";
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .about = is_about,
    .precedence = Precedence::after_text,
    .check = newer_than_build,
    .program_check = commands_newer_than_build,
};

}  // namespace axisc::validator::checks::ax2016
