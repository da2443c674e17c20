#include "axisc/answers/execution/timed_commands.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/joined.hpp"
#include "validator/commands/command_check.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence bad_timed_command{
    "--at {value}: expected CYCLE:COMMAND, for example \"100:#FILTER ON [ORDER=20]\"",
    "--at {value}: erwartet wird ZYKLUS:BEFEHL, zum Beispiel \"100:#FILTER ON [ORDER=20]\""};
constexpr Sentence bad_command{"--at {value}: {reason}", "--at {value}: {reason}"};
constexpr Sentence no_banks{
    "no axis of a channel in {file} has a FIR or HSC filter or a guard that \"{command}\" could switch",
    "keine Achse eines Kanals in {file} hat einen FIR- oder HSC-Filter oder einen Vibration Guard, den "
    "\"{command}\" schalten könnte"};
constexpr Sentence no_bank{
    "{file} has no kernels for \"{command}\", which asks for {needed}; it has: {banks}. Name "
    "`{needed}` in filter_sets of the machine file",
    "{file} enthält keine Kerne für \"{command}\", also für {needed}; vorhanden: {banks}. `{needed}` in "
    "filter_sets der Maschinendatei nennen"};
constexpr Sentence late{
    "--at {cycle}:{command}: there is no such cycle; there are the cycles 0 to {last}",
    "--at {cycle}:{command}: diesen Zyklus gibt es nicht; es gibt die Zyklen 0 bis {last}"};
constexpr Sentence command_busy{
    "\"{command}\" at cycle {cycle}: a filter is still changing over from the previous command",
    "\"{command}\" in Zyklus {cycle}: ein Filter ist noch im Übergang vom vorherigen Befehl"};
constexpr Sentence command_standstill{
    "\"{command}\" at cycle {cycle}: no transition within the limits of the axes is possible, only at "
    "standstill",
    "\"{command}\" in Zyklus {cycle}: kein Übergang innerhalb der Grenzen der Achsen, nur im Stillstand"};

}  // namespace axisc::says

namespace axisc {

namespace {

[[noreturn]] void refuse(SentenceRef text, TimedCommand const& command, std::string const& path,
                         std::vector<Argument> more = {}) {
  std::vector<Argument> arguments = {
      {"file", path}, {"command", command.text}, {"cycle", std::to_string(command.cycle)}};
  arguments.insert(arguments.end(), more.begin(), more.end());
  throw Failure({text, std::move(arguments)});
}

/// The command that switches a bank on.
std::string bank_text(machine::FilterParameters const& parameters, bool hsc) {
  return to_text(machine::FilterCommand{
      .filter_switch = machine::FilterSwitch::on, .hsc = hsc, .parameters = parameters});
}

/// "#FILTER ON, #FILTER ON [ORDER=20], #FILTER ON [HSC]": the commands that the image's channels can execute,
/// each once.
std::string banks_of(image::ImageContents const& image) {
  std::vector<std::string> banks;
  for (auto const& group : image.groups) {
    for (auto const& bank : group.banks) {
      auto const text = bank_text(bank.parameters, bank.hsc);
      if (std::find(banks.begin(), banks.end(), text) == banks.end()) banks.push_back(text);
    }
  }
  return joined(banks);
}

[[noreturn]] void refuse_bank(TimedCommand const& command, image::ImageContents const& image,
                              std::string const& path) {
  refuse(says::no_bank, command, path,
         {{"banks", banks_of(image)}, {"needed", bank_text(command.parameters, command.command.hsc)}});
}

/// An axis with the time delay bounds the order of the whole channel's commands.
validator::CommandLimits limits_of(image::ImageContents const& image) {
  validator::CommandLimits limits{.cycle_time = image.cycle_time, .time_delay = false};
  for (auto const& axis : image.axes) {
    if (!axis.slot || !axis.slot->kernel) continue;
    auto const& kernel = image.kernels[*axis.slot->kernel].specification;
    limits.time_delay = limits.time_delay || kernel.type == design::KernelType::time_delay;
    if (kernel.reading != design::KernelReading::documented) limits.readings.kernels = kernel.reading;
    if (kernel.cycle_time != design::CycleReading::documented) limits.readings.cycle_time = kernel.cycle_time;
  }
  return limits;
}

TimedCommand read_timed_command(std::string const& word, ImageFile const& file, std::string const& path,
                                Language language) {
  auto const colon = word.find(':');
  auto const cycle = parse_count(std::string_view(word).substr(0, colon));
  if (colon == std::string::npos || !cycle) {
    throw Failure({says::bad_timed_command, {{"value", word}}});
  }
  TimedCommand command{.cycle = *cycle, .text = word.substr(colon + 1), .command = {}, .parameters = {}};
  if (file.contents.groups.empty()) refuse(says::no_banks, command, path);
  auto checked = validator::parse_filter_command(command.text, limits_of(file.contents));
  if (!checked.mistakes.empty() || !checked.command) {
    throw Failure({says::bad_command, {{"value", word}, {"reason", why_unusable(checked, language)}}});
  }
  command.command = *checked.command;
  return command;
}

}  // namespace

std::vector<TimedCommand> read_timed_commands(std::vector<std::string> const& words, ImageFile const& file,
                                              std::string const& path, Language language) {
  std::vector<TimedCommand> commands;
  commands.reserve(words.size());
  for (auto const& word : words) commands.push_back(read_timed_command(word, file, path, language));
  std::stable_sort(commands.begin(), commands.end(),
                   [](TimedCommand const& a, TimedCommand const& b) { return a.cycle < b.cycle; });
  machine::FilterParameters current;
  for (auto& timed : commands) timed.parameters = current = parameters_after(current, timed.command);
  return commands;
}

void refuse_late(std::vector<TimedCommand> const& commands, std::uint64_t cycles) {
  if (commands.empty() || commands.back().cycle < cycles) return;
  refuse(says::late, commands.back(), {},
         {{"last", std::to_string(cycles - std::min<std::uint64_t>(cycles, 1))}});
}

void execute(TimedCommand const& command, image::RuntimeHost& host, image::ImageContents const& image,
             std::string const& path) {
  bool executed = false;
  for (std::uint32_t group = 0; group < host.group_count(); ++group) {
    switch (host.command(group, command.command)) {
      case AXISRT_OK: executed = true; break;
      case AXISRT_NO_BANK: break;
      case AXISRT_BUSY: refuse(says::command_busy, command, path);
      default: refuse(says::command_standstill, command, path);
    }
  }
  if (!executed) refuse_bank(command, image, path);
}

image::ImageBank const& bank_of(TimedCommand const& command, image::ImageGroup const& group,
                                image::ImageContents const& image, std::string const& path) {
  bool const hsc = command.command.hsc;
  auto const found = std::find_if(group.banks.begin(), group.banks.end(), [&](image::ImageBank const& bank) {
    return bank.hsc == hsc && (hsc || bank.parameters == command.parameters);
  });
  if (found == group.banks.end()) refuse_bank(command, image, path);
  return *found;
}

}  // namespace axisc
