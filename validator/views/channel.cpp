#include "validator/views/channel.hpp"

#include "configuration/filter_set_limit.hpp"
#include "validator/commands/command_check.hpp"
#include "validator/views/fir_view.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace axisc::validator::says {

constexpr Sentence not_compiled_command{"the command `{command}`, whose values cannot be used",
                                        "der Befehl `{command}`, dessen Werte nicht verwendbar sind"};

constexpr Sentence too_many_commands{"more than {limit} different filter commands in one group",
                                     "mehr als {limit} verschiedene Filterbefehle in einer Gruppe"};

}  // namespace axisc::validator::says

namespace axisc::validator {
namespace {

class SetCollector {
 public:
  SetCollector(CommandLimits const& limits, std::vector<NotCompiled>& not_compiled)
      : limits_(limits), not_compiled_(not_compiled) {}

  /// A program begins with the lists' values.
  void begin_program() { current_ = machine::FilterParameters{}; }

  void add(CheckedCommand const& checked, Place place, std::string_view written) {
    follow(checked);
    if (checked.command) {
      if (!current_ || (current_->empty() && !current_->guard)) return;
      if (std::find(sets.begin(), sets.end(), *current_) != sets.end()) return;
      if (sets.size() < configuration::most_filter_sets) {
        sets.push_back(*current_);
      } else if (!std::exchange(is_full_, true)) {
        refuse(place, says::too_many_commands, {{"limit", std::to_string(configuration::most_filter_sets)}});
      }
    } else if (!checked.mistakes.empty()) {
      refuse(place, says::not_compiled_command, {{"command", std::string(written)}});
    }
  }

  [[nodiscard]] CommandLimits const& limits() const { return limits_; }

  std::vector<machine::FilterParameters> sets;

 private:
  /// After a command whose values are unknown, only ON makes them known again.
  void follow(CheckedCommand const& checked) {
    if (!checked.command) {
      bool const changes = !checked.hsc && checked.filter_switch != machine::FilterSwitch::off;
      if (changes) current_.reset();
    } else if (current_ || checked.command->filter_switch == machine::FilterSwitch::on) {
      current_ = machine::parameters_after(current_.value_or(machine::FilterParameters{}), *checked.command);
    }
  }

  void refuse(Place place, SentenceRef text, std::vector<Argument> arguments) {
    not_compiled_.push_back({.place = place, .feature = {text, std::move(arguments)}});
  }

  CommandLimits const& limits_;
  std::vector<NotCompiled>& not_compiled_;
  bool is_full_ = false;
  std::optional<machine::FilterParameters> current_;
};

void add_program(LoadedProgram const& program, SourceSet const& sources, SetCollector& collector) {
  std::string_view const text = sources[program.source].bytes();
  collector.begin_program();
  for (grammar::NcCommand const& command : program.tree.commands) {
    bool const is_filter = command.kind == grammar::CommandKind::filter;
    if (!is_filter && command.kind != grammar::CommandKind::vibration_guard) continue;
    collector.add(check_command(command, text, collector.limits(), Variables::accepted),
                  {.source = program.source, .span = command.name}, is_filter ? "#FILTER" : "#VIB GUARD");
  }
}

}  // namespace

bool has_time_delay(LoadedMachine const& machine, LoadedGroup const& group) {
  return std::any_of(group.axes.begin(), group.axes.end(), [&](std::size_t axis) {
    return FirView(machine.axes[axis].merged.values).configured_type() == FirType::time_delay;
  });
}

std::vector<machine::FilterParameters> filter_sets_of(LoadedMachine const& machine, LoadedGroup const& group,
                                                      SourceSet const& sources,
                                                      std::vector<NotCompiled>& not_compiled) {
  CommandLimits const limits{.cycle_time = machine.cycle_time.value_or(design::CycleTime{}),
                             .time_delay = has_time_delay(machine, group),
                             .readings = machine.readings};
  SetCollector collector(limits, not_compiled);
  for (std::size_t const program : group.programs) add_program(machine.programs[program], sources, collector);
  for (configuration::LocatedText const& set : machine.filter_sets) {
    collector.begin_program();
    collector.add(parse_filter_command(set.text, limits), set.place, set.text);
  }
  return std::move(collector.sets);
}

bool has_command(LoadedMachine const& machine, LoadedGroup const& group, grammar::CommandKind kind) {
  auto const is_wanted = [kind](grammar::NcCommand const& command) { return command.kind == kind; };
  auto const& programs = group.programs;
  auto const& sets = machine.filter_sets;
  return std::any_of(programs.begin(), programs.end(),
                     [&](std::size_t program) {
                       auto const& commands = machine.programs[program].tree.commands;
                       return std::any_of(commands.begin(), commands.end(), is_wanted);
                     }) ||
         std::any_of(sets.begin(), sets.end(), [&](configuration::LocatedText const& set) {
           auto const command = grammar::parse_nc_command(set.text);
           return command && is_wanted(*command);
         });
}

}  // namespace axisc::validator
