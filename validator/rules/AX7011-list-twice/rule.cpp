#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

#include <map>

namespace axisc::validator::checks::ax7011::says {

constexpr Sentence headline{"`{parameter}` names the list of `{first}` again",
                            "`{parameter}` nennt die Liste von `{first}` noch einmal"};
constexpr Sentence first_here{"first here", "zuerst hier"};
constexpr Sentence note{"both axes get the same number (P-AXIS-00016)",
                        "beide Achsen erhalten dieselbe Nummer (P-AXIS-00016)"};
constexpr Sentence help{"name a list of its own for each axis; what they share belongs in the default list",
                        "für jede Achse eine eigene Liste nennen; Gemeinsames gehört in die Standardliste"};

}  // namespace axisc::validator::checks::ax7011::says

namespace axisc::validator::checks::ax7011 {
namespace {

std::string entry_name(configuration::ListEntry const& entry) {
  return "achs_mds[" + std::to_string(entry.index) + "]";
}

void list_twice(MachineContext const& context, Report& report) {
  LoadedMachine const& machine = context.machine;
  if (!machine.start_up) return;
  std::map<std::size_t, configuration::ListEntry const*> first;
  for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
    configuration::ListEntry const& entry = machine.start_up->list.axes[machine.start_up->entries[axis]];
    auto const [known, is_new] = first.try_emplace(machine.axes[axis].list, &entry);
    if (is_new) continue;
    Finding& finding = report.add(
        entry.file.place,
        {says::headline, {{"parameter", entry_name(entry)}, {"first", entry_name(*known->second)}}});
    finding.related.push_back({known->second->file.place, {says::first_here, {}}});
    finding.notes.push_back({says::note, {}});
    finding.help.push_back({says::help, {}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .check = list_twice,
};

}  // namespace axisc::validator::checks::ax7011
