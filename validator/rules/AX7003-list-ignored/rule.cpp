#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"`{parameter}` is not read: `{count}` is {number}",
                            "`{parameter}` wird nicht gelesen: `{count}` ist {number}"};
constexpr Sentence missing{"`{parameter}` is not read: no line sets `{count}`",
                           "`{parameter}` wird nicht gelesen: keine Zeile setzt `{count}`"};
constexpr Sentence count_here{"the number is set here", "hier wird die Anzahl gesetzt"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

struct Array {
  std::string_view name, count_name;
  std::optional<configuration::ListCount> const& count;
  Report& report;

  void check(configuration::ListEntry const& entry) const {
    if (entry.file.text.empty() || is_read(entry, count)) return;
    std::vector<Argument> arguments{
        {"parameter", std::string(name) + "[" + std::to_string(entry.index) + "]"},
        {"count", std::string(count_name)}};
    if (!count) {
      report.add(entry.file.place, {says::missing, std::move(arguments)});
      return;
    }
    arguments.push_back({"number", std::to_string(count->number)});
    report.add(entry.file.place, {says::headline, std::move(arguments)})
        .related.push_back({count->place, {says::count_here, {}}});
  }
};

void list_ignored(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  configuration::StartUpList const& list = context.machine.start_up->list;
  Array const axes{"achs_mds", "zahl_mds", list.axis_count, report};
  for (configuration::ListEntry const& entry : list.axes) axes.check(entry);
  Array const channels{"sda_mds", "kanal_anzahl", list.channel_count, report};
  for (configuration::ListEntry const& entry : list.channels) channels.check(entry);
  Array const compensations{"achs_kw", "zahl_kw", list.compensation_count, report};
  for (configuration::CompensationEntry const& entry : list.compensations) compensations.check(entry.list);
}

}  // namespace

extern constinit Rule const ax7003{
    .severity = Severity::warning,
    .check = list_ignored,
};

}  // namespace axisc::validator::checks
