#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

#include <map>
#include <set>

namespace axisc::validator::checks::ax7010::says {

constexpr Sentence headline{"axis {number} belongs to two channels", "Achse {number} gehört zu zwei Kanälen"};
constexpr Sentence first_here{"first here", "zuerst hier"};
constexpr Sentence note{
    "this is allowed for axes that programs exchange; at start-up only one channel gets it",
    "das ist für Achsen erlaubt, die Programme tauschen; beim Hochlauf erhält sie nur ein Kanal"};
constexpr Sentence help{"if programs do not exchange it, give each channel an axis of its own",
                        "tauschen Programme sie nicht, jedem Kanal eine eigene Achse geben"};

}  // namespace axisc::validator::checks::ax7010::says

namespace axisc::validator::checks::ax7010 {
namespace {

void axis_in_two_channels(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  std::map<std::uint32_t, Place> first;
  std::set<std::uint32_t> told;
  for (StartUpChannel const& channel : context.machine.start_up->channels) {
    for (configuration::ChannelAxis const& axis : channel.list.axes) {
      auto const [known, is_new] = first.try_emplace(axis.number->number, axis.number->place);
      bool const same_list = known->second.source == axis.number->place.source;
      if (is_new || same_list || !told.insert(axis.number->number).second) continue;
      Finding& finding =
          report.add(axis.number->place, {says::headline, {{"number", std::to_string(axis.number->number)}}});
      finding.related.push_back({known->second, {says::first_here, {}}});
      finding.notes.push_back({says::note, {}});
      finding.help.push_back({says::help, {}});
    }
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "kopf.achs_nr",
    .check = axis_in_two_channels,
};

}  // namespace axisc::validator::checks::ax7010
