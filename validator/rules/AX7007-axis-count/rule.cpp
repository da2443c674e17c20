#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax7007::says {

constexpr Sentence headline{"`{parameter}` is {number}, but the list configures {configured}",
                            "`{parameter}` ist {number}, die Liste konfiguriert aber {configured}"};
constexpr Sentence outside{"`{parameter}` is {number}; allowed are 0 to {limit}",
                           "`{parameter}` ist {number}; zulässig sind 0 bis {limit}"};
constexpr Sentence no_axis{"the start-up list configures no axis: `zahl_mds` is {number}",
                           "die Hochlaufliste konfiguriert keine Achse: `zahl_mds` ist {number}"};
constexpr Sentence no_count{"the start-up list configures no axis: no line sets `zahl_mds`",
                            "die Hochlaufliste konfiguriert keine Achse: keine Zeile setzt `zahl_mds`"};
constexpr Sentence reaction{"it reports that the number of axes is wrong",
                            "sie meldet, dass die Anzahl der Achsen falsch ist"};
constexpr Sentence help_count{"write {configured}, or add what is missing",
                              "{configured} schreiben, oder ergänzen, was fehlt"};
constexpr Sentence help_axes{
    "set `zahl_mds` to the number of axis lists, and name them as `achs_mds[0]` and so on",
    "`zahl_mds` auf die Anzahl der Achslisten setzen, und diese als `achs_mds[0]` und so weiter nennen"};

}  // namespace axisc::validator::checks::ax7007::says

namespace axisc::validator::checks::ax7007 {
namespace {

// Message numbers of the control.
constexpr std::string_view out_of_range = "20427";
constexpr std::string_view not_as_configured = "20428";

constexpr std::uint32_t most_axes = 32;
constexpr std::uint32_t most_spindles = 6;

void check_count(std::string_view parameter, std::optional<configuration::ListCount> const& count,
                 std::size_t configured, std::uint32_t limit, Report& report) {
  if (!count || (count->number == configured && count->number <= limit)) return;
  std::vector<Argument> arguments{{"parameter", std::string(parameter)},
                                  {"number", std::to_string(count->number)}};
  bool const outside = count->number > limit;
  arguments.push_back(outside ? Argument{"limit", std::to_string(limit)}
                              : Argument{"configured", std::to_string(configured)});
  Finding& finding =
      report.add(count->place, {outside ? says::outside : says::headline, std::move(arguments)});
  if (!outside) finding.help.push_back({says::help_count, {{"configured", std::to_string(configured)}}});
  react(finding, outside ? out_of_range : not_as_configured, {says::reaction, {}});
}

/// A control has 1 to 32 axes. An update in XML need not name them.
void check_machine(MachineContext const& context, Report& report) {
  StartUp const& start_up = *context.machine.start_up;
  if (start_up.is_project || context.sources[start_up.sources.front()].is_translation()) return;
  auto const& count = start_up.list.axis_count;
  if (count && count->number > 0) return;
  SourceId const source = start_up.sources.front();
  std::uint32_t const begin = context.sources[source].text_begin();
  Place const place = count ? count->place : Place{.source = source, .span = {.begin = begin, .end = begin}};
  Message message{says::no_count, {}};
  if (count) message = {says::no_axis, {{"number", std::to_string(count->number)}}};
  // It is not documented which of its messages the control then gives.
  Finding& finding = report.add(place, std::move(message));
  finding.control.reset();
  finding.help.push_back({says::help_axes, {}});
}

void axis_count(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  check_machine(context, report);
  for (StartUpChannel const& channel : context.machine.start_up->channels) {
    configuration::ChannelList const& list = channel.list;
    check_count("gruppe[0].achs_anzahl", list.axis_count, list.axes.size(), most_axes, report);
    check_count("spdl_anzahl", list.spindle_count, list.spindles.size(), most_spindles, report);
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<out_of_range, not_as_configured>,
    .check = axis_count,
};

}  // namespace axisc::validator::checks::ax7007
