#include "editor/meaning/named_axes.hpp"

#include "configuration/channel_list.hpp"
#include "configuration/list_kind.hpp"
#include "configuration/machine_file.hpp"
#include "editor/reading/places.hpp"

#include <deque>
#include <utility>

namespace axisc::editor {

namespace {

std::optional<std::size_t> axis_in_channel(validator::LoadedMachine const& machine, SourceText const& text,
                                           std::size_t offset) {
  auto const channel = configuration::read_channel_list(text, SourceId{});
  auto const is_at = [offset](auto const& located) {
    return located && touches(located->place.span, offset);
  };
  for (auto const* const axes : {&channel.axes, &channel.spindles}) {
    for (auto const& axis : *axes) {
      if (!axis.number || (!is_at(axis.number) && !is_at(axis.name))) continue;
      return validator::axis_numbered(machine, axis.number->number);
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> axis_in_machine_file(validator::LoadedMachine const& machine, SourceText text,
                                                std::size_t offset) {
  SourceSet sources;
  std::deque<Finding> mistakes;
  auto const source = sources.add(std::move(text));
  auto const file = configuration::read_machine_file(sources, source, mistakes);
  std::vector<configuration::LocatedText> names;
  for (auto const& group : file.groups) names.insert(names.end(), group.axes.begin(), group.axes.end());
  for (auto const& gantry : file.gantries) {
    names.push_back(gantry.master);
    names.insert(names.end(), gantry.slaves.begin(), gantry.slaves.end());
  }
  for (auto const& name : names) {
    if (!touches(name.place.span, offset)) continue;
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
      if (machine.axes[i].name == name.text) return i;
    }
    break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> list_of_named_axis(MachineReading const& reading, OpenDocument const& document,
                                              std::size_t offset) {
  auto const* const machine = reading.machine();
  if (machine == nullptr) return std::nullopt;
  std::optional<std::size_t> axis;
  SourceText text(document.path, document.text);
  if (!document.path.ends_with(".json")) {
    bool const is_channel = configuration::decided_kind(text) == configuration::ListKind::channel;
    if (is_channel) axis = axis_in_channel(*machine, text, offset);
  } else if (configuration::looks_like_machine_file(document.text)) {
    axis = axis_in_machine_file(*machine, std::move(text), offset);
  }
  if (!axis) return std::nullopt;
  return reading.sources()[machine->lists[machine->axes[*axis].list].list.source].name();
}

}  // namespace axisc::editor
