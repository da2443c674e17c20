#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"

#include <array>
#include <map>
#include <set>

namespace axisc::validator::checks::ax7010::says {

constexpr Sentence headline{"axis {number} belongs to two channels", "Achse {number} gehört zu zwei Kanälen"};
constexpr Sentence number_twice{"this channel has axis {number} twice",
                                "dieser Kanal hat Achse {number} zweimal"};
constexpr Sentence name_twice{"two axes of this channel have the name \"{name}\"",
                              "zwei Achsen dieses Kanals haben den Namen „{name}“"};
constexpr Sentence reaction_number{"it reports the number as used twice",
                                   "sie meldet die Nummer als doppelt vergeben"};
constexpr Sentence reaction_name{"it reports the name as used twice",
                                 "sie meldet den Namen als doppelt vergeben"};
constexpr Sentence help_number{"write the number of another axis, or remove the entry",
                               "die Nummer einer anderen Achse schreiben, oder den Eintrag entfernen"};
constexpr Sentence help_name{"give each axis a name of its own", "jeder Achse einen eigenen Namen geben"};
constexpr Sentence first_here{"first here", "zuerst hier"};
constexpr Sentence note{
    "this is allowed for axes that programs exchange; at start-up only one channel gets it",
    "das ist für Achsen erlaubt, die Programme tauschen; beim Hochlauf erhält sie nur ein Kanal"};
constexpr Sentence help{"if programs do not exchange it, give each channel an axis of its own",
                        "tauschen Programme sie nicht, jedem Kanal eine eigene Achse geben"};

}  // namespace axisc::validator::checks::ax7010::says

namespace axisc::validator::checks::ax7010 {
namespace {

using configuration::ChannelAxis;
using configuration::ChannelList;

// Message numbers of the control.
constexpr std::string_view spindle_name = "20419";
constexpr std::string_view spindle_number = "20420";
constexpr std::string_view axis_number = "20423";
constexpr std::string_view axis_name = "20424";

struct Kind {
  std::vector<ChannelAxis> ChannelList::*axes;
  std::string_view same_number, same_name;
};
constexpr std::array kinds = {
    Kind{.axes = &ChannelList::axes, .same_number = axis_number, .same_name = axis_name},
    Kind{.axes = &ChannelList::spindles, .same_number = spindle_number, .same_name = spindle_name}};

/// The path axes of one channel among themselves, or its spindles.
void check_channel(std::vector<ChannelAxis> const& axes, Kind const& kind, Report& report) {
  std::map<std::uint32_t, Place> numbers;
  std::map<std::string_view, Place> names;
  for (ChannelAxis const& axis : axes) {
    auto const [number, is_new_number] = numbers.try_emplace(axis.number->number, axis.number->place);
    if (!is_new_number) {
      Finding& finding = report.add(axis.number->place,
                                    {says::number_twice, {{"number", std::to_string(axis.number->number)}}});
      finding.severity = Severity::error;
      finding.related.push_back({number->second, {says::first_here, {}}});
      finding.help.push_back({says::help_number, {}});
      react(finding, kind.same_number, {says::reaction_number, {}});
      continue;
    }
    if (!axis.name) continue;
    auto const [name, is_new_name] = names.try_emplace(axis.name->text, axis.name->place);
    if (is_new_name) continue;
    Finding& finding = report.add(axis.name->place, {says::name_twice, {{"name", axis.name->text}}});
    finding.severity = Severity::error;
    finding.related.push_back({name->second, {says::first_here, {}}});
    finding.help.push_back({says::help_name, {}});
    react(finding, kind.same_name, {says::reaction_name, {}});
  }
}

void axis_in_two_channels(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  for (StartUpChannel const& channel : context.machine.start_up->channels) {
    for (Kind const& kind : kinds) check_channel(channel.list.*kind.axes, kind, report);
  }
  std::map<std::uint32_t, Place> first;
  std::set<std::uint32_t> told;
  for (StartUpChannel const& channel : context.machine.start_up->channels) {
    for (configuration::ChannelAxis const& axis : channel.list.axes) {
      auto const [known, is_new] = first.try_emplace(axis.number->number, axis.number->place);
      bool const same_list = known->second.source == axis.number->place.source;
      if (is_new || same_list || !told.insert(axis.number->number).second) continue;
      Finding& finding =
          report.add(axis.number->place, {says::headline, {{"number", std::to_string(axis.number->number)}}});
      finding.control.reset();
      finding.related.push_back({known->second, {says::first_here, {}}});
      finding.notes.push_back({says::note, {}});
      finding.help.push_back({says::help, {}});
    }
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = control_numbers<spindle_name, spindle_number, axis_number, axis_name>,
    .parameters = "kopf.achs_nr",
    .check = axis_in_two_channels,
};

}  // namespace axisc::validator::checks::ax7010
