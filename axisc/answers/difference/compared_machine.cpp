#include "axisc/answers/difference/compared_machine.hpp"

#include "axisc/checking/compiled_input.hpp"
#include "axisc/checking/machine_input.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/files/path_identity.hpp"
#include "axisc/workspace/inputs.hpp"
#include "validator/values/list_reader.hpp"
#include "validator/views/drive.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace axisc {

namespace {

std::vector<std::string> names_of(std::vector<ComparedAxis> const& axes,
                                  std::vector<std::size_t> const& indices) {
  std::vector<std::string> names;
  names.reserve(indices.size());
  for (auto const index : indices) names.push_back(axes[index].name);
  return names;
}

std::string name_or_number(std::string const& name, std::size_t index) {
  return name.empty() ? std::to_string(index + 1) : name;
}

class FromLists {
 public:
  explicit FromLists(ComparedMachine& side) : side_(side), machine_(*side.loaded) {}

  void fill() {
    side_.tells_all = true;
    side_.cycle_time = machine_.cycle_time.value_or(design::CycleTime{});
    side_.cycle_time_known = machine_.cycle_time.has_value();
    side_.tells_channels = machine_.start_up.has_value() || machine_.machine_file.has_value();
    for (std::size_t i = 0; i < machine_.axes.size(); ++i) add_axis(i);
    for (std::size_t i = 0; i < machine_.groups.size(); ++i) add_channel(i);
    if (machine_.start_up) add_channel_lists();
    for (auto const& gantry : machine_.gantries) {
      side_.gantries.push_back(
          {.master = side_.axes[gantry.master].name, .slaves = names_of(side_.axes, gantry.slaves)});
    }
  }

 private:
  void add_axis(std::size_t index) {
    auto const& axis = machine_.axes[index];
    auto const& number = axis.merged.values.at("kopf.achs_nr");
    auto const* const drive = validator::drive_of(axis);
    ComparedAxis compared;
    compared.name = axis.name;
    if (number.set() && !number.unusable) compared.number = static_cast<std::uint32_t>(number.value.number);
    compared.list = machine_.lists[axis.list].name;
    compared.path = side_.sources[machine_.lists[axis.list].list.source].name();
    compared.type = axis.type;
    if (drive != nullptr) compared.drive = drive->word;
    compared.values = &axis.merged.values;
    compared.index = index;
    side_.axes.push_back(std::move(compared));
  }

  void add_channel(std::size_t index) {
    auto const& group = machine_.groups[index];
    ComparedChannel channel;
    channel.name = name_or_number(group.name, index);
    channel.axes = names_of(side_.axes, group.axes);
    for (auto const program : group.programs) {
      channel.programs.push_back(
          {.name = machine_.programs[program].name, .mark = machine_.programs[program].mark});
    }
    for (auto const& pair : group.pairs) {
      channel.couplings.push_back(axis_name(pair.slave) + " = " + axis_name(pair.master));
    }
    channel.dynamics = channel_values(group.dynamics);
    side_.channels.push_back(std::move(channel));
  }

  void add_channel_lists() {
    for (auto const& channel : machine_.start_up->channels) {
      auto& compared = side_.channels[channel.group];
      for (auto const& axis : channel.list.axes) note_name(axis);
      for (auto const& spindle : channel.list.spindles) {
        note_name(spindle);
        compared.spindles.push_back(axis_name(spindle.number));
      }
    }
  }

  void note_name(configuration::ChannelAxis const& named) {
    if (!named.number || !named.name) return;
    auto const axis = validator::axis_numbered(machine_, named.number->number);
    if (axis) side_.axes[*axis].called.push_back(named.name->text);
  }

  [[nodiscard]] std::string axis_name(std::optional<configuration::ListCount> const& number) const {
    if (!number) return "?";
    auto const axis = validator::axis_numbered(machine_, number->number);
    return axis ? side_.axes[*axis].name : std::to_string(number->number);
  }

  ComparedMachine& side_;
  validator::LoadedMachine const& machine_;
};

/// The values that an image remembers, read again as one list, so that the same judgement applies to both
/// sides.
validator::EffectiveValues const& values_of(ComparedMachine& side, image::ImageAxis const& axis,
                                            schema::Catalogue const& catalogue) {
  std::string text;
  for (auto const& value : axis.values) text.append(value.name).append(" ").append(value.value).append("\n");
  auto const source = side.sources.add(SourceText(axis.name, std::move(text)));
  auto read = validator::read_list(side.sources[source], catalogue);
  auto& list = side.lists.emplace_back();
  list.source = source;
  list.catalogue = catalogue;
  list.tree = std::move(read.tree);
  list.line_values = std::move(read.line_values);
  return side.merged.emplace_back(validator::merge_lists(nullptr, list, std::nullopt)).values;
}

void fill_from_image(ComparedMachine& side, schema::Catalogue const& catalogue) {
  auto const& contents = side.image->contents;
  side.cycle_time = contents.cycle_time;
  side.tells_channels = contents.axes.size() > 1 && !contents.axes.front().name.empty();
  for (std::size_t i = 0; i < contents.axes.size(); ++i) {
    auto const& axis = contents.axes[i];
    ComparedAxis compared;
    compared.name = axis_label(contents, i);
    compared.index = i;
    compared.type = static_cast<machine::AxisType>(axis.type);
    if (!axis.name.empty()) {
      compared.values = &values_of(side, axis, catalogue);
      compared.origins = &axis.values;
      auto const& number = compared.values->at("kopf.achs_nr");
      if (number.set()) compared.number = axis.number;
    }
    side.axes.push_back(std::move(compared));
  }
  for (std::size_t i = 0; i < contents.groups.size(); ++i) {
    ComparedChannel channel;
    channel.name = name_or_number(contents.groups[i].name, i);
    channel.axes = names_of(side.axes, contents.groups[i].members);
    side.channels.push_back(std::move(channel));
  }
}

}  // namespace

std::string ComparedMachine::place_of(ComparedAxis const& axis,
                                      validator::EffectiveValue const& value) const {
  if (!value.set()) return {};
  if (axis.origins != nullptr) {
    auto const& origin = (*axis.origins)[value.line - 1];
    return origin.list + ":" + std::to_string(origin.line);
  }
  return sources[value.source].name() + ":" + std::to_string(value.line);
}

std::string ComparedMachine::written(validator::EffectiveValue const& value) const {
  auto const place = value.value_place();
  return place ? sources[place->source].utf8(place->span) : std::string();
}

std::unique_ptr<ComparedMachine> compared_machine(Workspace& workspace, std::string const& input,
                                                  ErrorSink const& errors) {
  auto side = std::make_unique<ComparedMachine>();
  side->input = input;
  auto const path = machine_input(input);
  if (auto image = image_in(workspace, path)) {
    side->image = std::move(*image);
    fill_from_image(*side, workspace.options_of(path).catalogue);
    return side;
  }
  auto result = check_machine(workspace, path, errors, side->sources, side->loaded);
  if (result) {
    side->image = image_of(*result->machine, path);
    side->machine = *std::move(result->machine);
  }
  if (side->loaded->axes.empty()) return nullptr;
  FromLists(*side).fill();
  return side;
}

namespace {

std::optional<std::string> list_of_both(ComparedMachine const& before, ComparedMachine const& after) {
  PathIdentities identities;
  bool const are_start_up_lists =
      before.loaded && after.loaded && before.loaded->start_up && after.loaded->start_up;
  if (!are_start_up_lists || identities.of(before.loaded->path) == identities.of(after.loaded->path)) {
    return std::nullopt;
  }
  std::map<std::string, std::string> read_after;
  for (auto const& is : after.axes) read_after.emplace(identities.of(is.path), is.path);
  for (auto const& was : before.axes) {
    auto const same = read_after.find(identities.of(was.path));
    if (same != read_after.end()) return same->second;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ComparedSides> compared_sides(Workspace& workspace, std::string const& before,
                                            std::string const& after, ErrorSink const& errors) {
  ComparedSides sides{.before = compared_machine(workspace, before, errors), .after = {}};
  sides.after = after == before ? sides.before : compared_machine(workspace, after, errors);
  if (!sides.before || !sides.after) return std::nullopt;
  auto const& known = sides.before->cycle_time_known ? *sides.before : *sides.after;
  auto& unknown = sides.before->cycle_time_known ? sides.after : sides.before;
  if (known.cycle_time_known && !unknown->cycle_time_known && unknown->image && unknown->input != "-") {
    workspace.assume(known.cycle_time);
    unknown = compared_machine(workspace, unknown->input, errors);
  }
  sides.read_by_both = list_of_both(*sides.before, *sides.after);
  return sides;
}

}  // namespace axisc
