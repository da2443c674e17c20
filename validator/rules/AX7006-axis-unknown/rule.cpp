#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax7006::says {

constexpr Sentence headline{"no axis list has the number {number}",
                            "keine Achsliste hat die Nummer {number}"};
constexpr Sentence known{"the axes of this machine have the numbers {numbers}",
                         "die Achsen dieser Maschine haben die Nummern {numbers}"};
constexpr Sentence reaction{"it reports the axis number as unknown",
                            "sie meldet die Achsnummer als unbekannt"};
constexpr Sentence help{
    "write one of these numbers, or name the list of the axis in the start-up list",
    "eine dieser Nummern schreiben, oder die Liste der Achse in der Hochlaufliste nennen"};

}  // namespace axisc::validator::checks::ax7006::says

namespace axisc::validator::checks::ax7006 {
namespace {

class Numbers {
 public:
  Numbers(LoadedMachine const& machine, Report& report) : machine_(machine), report_(report) {}

  void check(std::optional<configuration::ListCount> const& number) const {
    if (!number || number->number == 0 || axis_numbered(machine_, number->number)) return;
    Finding& finding =
        report_.add(number->place, {says::headline, {{"number", std::to_string(number->number)}}});
    finding.notes.push_back({says::known, {{"numbers", known()}}});
    finding.help.push_back({says::help, {}});
    react(finding, {says::reaction, {}});
  }

 private:
  [[nodiscard]] std::string known() const {
    std::string numbers;
    for (LoadedAxis const& axis : machine_.axes) {
      EffectiveValue const& own = axis.merged.values.at("kopf.achs_nr");
      if (!own.unusable) numbers += (numbers.empty() ? "" : ", ") + number(own.value.number).written();
    }
    return numbers;
  }

  LoadedMachine const& machine_;
  Report& report_;
};

void axis_unknown(MachineContext const& context, Report& report) {
  LoadedMachine const& machine = context.machine;
  // If the list of an axis is missing, or does not say its number, the numbers of the machine are unknown.
  if (!machine.start_up || !machine.knows_all_axes) return;
  if (!std::all_of(machine.axes.begin(), machine.axes.end(), has_own_number)) return;
  Numbers const numbers(machine, report);
  for (StartUpChannel const& channel : machine.start_up->channels) {
    for (configuration::ChannelAxis const& axis : channel.list.axes) numbers.check(axis.number);
    for (configuration::ChannelAxis const& spindle : channel.list.spindles) numbers.check(spindle.number);
    for (configuration::CoupledPair const& pair : channel.list.pairs) {
      numbers.check(pair.slave);
      numbers.check(pair.master);
    }
  }
  for (StartUpCompensation const& compensation : machine.start_up->compensations) {
    numbers.check(compensation.entry.axis);
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = "150010",
    .parameters = "kopf.achs_nr",
    .check = axis_unknown,
};

}  // namespace axisc::validator::checks::ax7006
