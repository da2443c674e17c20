#include "validator/loading/loading.hpp"

#include "validator/commands/command_check.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>

namespace axisc::validator {

bool has_own_number(LoadedAxis const& axis) {
  EffectiveValue const& number = axis.merged.values.at("kopf.achs_nr");
  return number.origin == Origin::axis_list || number.unusable;
}

std::optional<std::size_t> axis_numbered(LoadedMachine const& machine, std::uint32_t number) {
  for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
    EffectiveValue const& own = machine.axes[axis].merged.values.at("kopf.achs_nr");
    if (!own.unusable && own.value.number == number) return axis;
  }
  return std::nullopt;
}

bool forget_guesses(LoadedMachine& machine) {
  std::size_t guesses = 0;
  for (NamedList& named : machine.lists) {
    guesses += std::erase_if(named.list.lost, [](LostAssignment const& lost) { return lost.guessed; });
  }
  if (guesses == 0) return false;
  for (LoadedAxis& axis : machine.axes) {
    axis.merged = merge_lists(machine.list_of_defaults(), machine.lists[axis.list].list,
                              axis.type != machine::AxisType::translatory);
    axis.merged.values.read_as(machine.readings);
  }
  return true;
}

bool program_gives_order(LoadedMachine const& machine, std::size_t axis) {
  auto const belongs = [axis](LoadedGroup const& group) {
    return std::find(group.axes.begin(), group.axes.end(), axis) != group.axes.end();
  };
  for (LoadedGroup const& group : machine.groups) {
    if (!belongs(group)) continue;
    for (std::size_t const program : group.programs) {
      if (machine.programs[program].gives_order) return true;
    }
    for (configuration::LocatedText const& text : machine.filter_sets) {
      auto const command = grammar::parse_nc_command(text.text);
      if (command && gives_order(*command, text.text)) return true;
    }
  }
  return false;
}

std::variant<LoadedMachine, configuration::FileError> load(configuration::Files& files,
                                                           std::string const& path,
                                                           CheckOptions const& options, SourceSet& sources) {
  std::variant<LoadedMachine, configuration::FileError> loaded;
  auto const error = Loader(files, options, sources, std::get<LoadedMachine>(loaded)).load(path);
  if (error) loaded = *error;
  return loaded;
}

}  // namespace axisc::validator
