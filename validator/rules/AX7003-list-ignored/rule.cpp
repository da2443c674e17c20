#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax7003::says {

constexpr Sentence headline{"`{parameter}` is not read: `{count}` is {number}",
                            "`{parameter}` wird nicht gelesen: `{count}` ist {number}"};
constexpr Sentence missing{"`{parameter}` is not read: no line sets `{count}`",
                           "`{parameter}` wird nicht gelesen: keine Zeile setzt `{count}`"};
constexpr Sentence count_here{"the number is set here", "hier wird die Anzahl gesetzt"};
constexpr Sentence help{"set `{count}` to at least {needed}, or remove the entry",
                        "`{count}` auf mindestens {needed} setzen, oder den Eintrag entfernen"};

}  // namespace axisc::validator::checks::ax7003::says

namespace axisc::validator::checks::ax7003 {
namespace {

struct Array {
  std::string_view name, count_name;
  std::optional<configuration::ListCount> const& count;
  Report& report;
  Severity severity_of_none = Severity::warning;  ///< where none of the entries is read

  void check(configuration::ListEntry const& entry) const {
    if (entry.file.text.empty() || is_read(entry, count)) return;
    std::vector<Argument> arguments{
        {"parameter", std::string(name) + "[" + std::to_string(entry.index) + "]"},
        {"count", std::string(count_name)}};
    Message help{says::help,
                 {{"count", std::string(count_name)}, {"needed", std::to_string(entry.index + 1)}}};
    if (!count) {
      Finding& finding = report.add(entry.file.place, {says::missing, std::move(arguments)});
      finding.severity = severity_of_none;
      finding.help.push_back(std::move(help));
      return;
    }
    arguments.push_back({"number", std::to_string(count->number)});
    Finding& finding = report.add(entry.file.place, {says::headline, std::move(arguments)});
    if (count->number == 0) finding.severity = severity_of_none;
    finding.related.push_back({count->place, {says::count_here, {}}});
    finding.help.push_back(std::move(help));
  }
};

void list_ignored(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  configuration::StartUpList const& list = context.machine.start_up->list;
  Array const axes{"achs_mds", "zahl_mds", list.axis_count, report};
  for (configuration::ListEntry const& entry : list.axes) axes.check(entry);
  // A control has 1 to 12 channels. An update in XML need not say how many.
  StartUp const& start_up = *context.machine.start_up;
  bool const is_update = !start_up.is_project && context.sources[start_up.sources.front()].is_translation();
  Array const channels{"sda_mds", "kanal_anzahl", list.channel_count, report,
                       is_update ? Severity::warning : Severity::error};
  for (configuration::ListEntry const& entry : list.channels) channels.check(entry);
  Array const compensations{"achs_kw", "zahl_kw", list.compensation_count, report};
  for (configuration::CompensationEntry const& entry : list.compensations) compensations.check(entry.list);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .check = list_ignored,
};

}  // namespace axisc::validator::checks::ax7003
