#include "configuration/listed_values.hpp"
#include "diagnostics/ascii.hpp"
#include "system/path.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace axisc::validator {
namespace {

/// The look-ahead of a channel (P-STUP-00070, 00071); a project says nothing.
configuration::ListedLookAhead look_ahead_of(StartUp const& start_up, std::uint32_t channel,
                                             SourceSet const& sources) {
  configuration::ListedLookAhead listed;
  if (start_up.is_project) return listed;
  SourceId const list = start_up.sources.front();
  configuration::read_look_ahead(configuration::listed_values(sources[list], list), channel, listed);
  return listed;
}

using configuration::ChannelAxis;
using configuration::ListEntry;
using configuration::ListKind;
using configuration::LocatedText;

struct Scheduling {
  std::string_view word;
  machine::PositionController controller;
};
constexpr std::array schedulings = {Scheduling{"OPT_DRIVE_POS_CONTROL", machine::PositionController::drive},
                                    Scheduling{"OPT_CNC_POS_CONTROL", machine::PositionController::cnc}};

machine::PositionController scheduled_controller(std::optional<LocatedText> const& word) {
  for (Scheduling const& scheduling : schedulings) {
    if (word && ascii::equal_ignoring_case(word->text, scheduling.word)) return scheduling.controller;
  }
  return machine::PositionController::unknown;
}

/// The channel's name for the axis with this number; null where there is none.
LocatedText const* name_in_channels(StartUp const& start_up, double number) {
  for (StartUpChannel const& channel : start_up.channels) {
    for (auto const* const axes : {&channel.list.axes, &channel.list.spindles}) {
      auto const axis = std::find_if(axes->begin(), axes->end(), [number](ChannelAxis const& each) {
        return each.name && each.number->number == number;
      });
      if (axis != axes->end()) return &*axis->name;
    }
  }
  return nullptr;
}

/// Counts entries in the order of their indices.
struct NamedEntries {
  std::uint32_t named = 0;  ///< this many from the first on have a file

  void add(ListEntry const& entry) {
    if (entry.index == named && !entry.file.text.empty()) ++named;
  }
  void note_next(std::string_view array, ListKind kind, std::optional<configuration::ListCount> const& count,
                 StartUp& start_up) const {
    if (!count || named >= count->number) return;
    std::string entry = std::string(array) + "[" + std::to_string(named) + "]";
    start_up.searches.push_back({.named = {.text = std::move(entry), .place = count->place},
                                 .sought = Sought::unnamed_list,
                                 .found = std::nullopt,
                                 .wanted = kind});
  }
};

}  // namespace

void Loader::load_start_up_list(SourceId source) {
  StartUp& start_up = machine_.start_up.emplace();
  start_up.sources.push_back(source);
  add_other_list(source, ListKind::startup, std::string(file_name(machine_.path)));
  start_up.list = configuration::read_start_up_list(sources_[source], source);
  note_unnamed_lists(start_up);
  load_default_axis_list(start_up);
  machine::PositionController const controller = scheduled_controller(start_up.list.position_control);
  for (std::size_t i = 0; i < start_up.list.axes.size(); ++i) {
    ListEntry const& entry = start_up.list.axes[i];
    if (entry.file.text.empty() || !configuration::is_read(entry, start_up.list.axis_count)) continue;
    auto const list = axis_list_found(start_up, entry.file);
    if (!list) {
      machine_.knows_all_axes = false;
      continue;
    }
    add_axis(*list, std::nullopt).position_control = controller;
    start_up.entries.push_back(i);
  }
  if (start_up.list.real_time) {
    auto const real_time = source_found(start_up, *start_up.list.real_time, ListKind::real_time);
    if (real_time) {
      start_up.real_time =
          configuration::read_real_time_list(sources_[*real_time], *real_time, machine_.findings);
    }
    machine_.cycle_time = start_up.real_time.cycle_time;
  }
  load_channels(start_up);
  load_compensations(start_up);
  name_axes(start_up);
}

void Loader::note_unnamed_lists(StartUp& start_up) {
  // An update in XML holds only what changes.
  if (sources_[start_up.sources.front()].is_translation()) return;
  NamedEntries axes;
  for (ListEntry const& entry : start_up.list.axes) axes.add(entry);
  axes.note_next("achs_mds", ListKind::axis, start_up.list.axis_count, start_up);
  machine_.knows_all_axes = start_up.searches.empty();
  NamedEntries compensations;
  for (configuration::CompensationEntry const& each : start_up.list.compensations) {
    compensations.add(each.list);
  }
  compensations.note_next("achs_kw", ListKind::compensation, start_up.list.compensation_count, start_up);
  NamedEntries channels;
  for (ListEntry const& entry : start_up.list.channels) channels.add(entry);
  channels.note_next("sda_mds", ListKind::channel, start_up.list.channel_count, start_up);
  machine_.complete = start_up.searches.empty();
}

void Loader::load_default_axis_list(StartUp& start_up) {
  if (!start_up.list.default_axis_list) return;
  machine_.default_list = axis_list_found(start_up, *start_up.list.default_axis_list);
  if (machine_.default_list) machine_.lists[*machine_.default_list].list.is_default_list = true;
  by_path_.clear();
}

void Loader::load_channels(StartUp& start_up) {
  // The default list completes the channels, and names no axes.
  if (start_up.list.default_channel) {
    auto const source = source_found(start_up, *start_up.list.default_channel, ListKind::channel);
    if (source) default_channel_ = configuration::read_channel_list(sources_[*source], *source);
    machine_.default_channel_list = source;
  }
  for (ListEntry const& entry : start_up.list.channels) {
    if (entry.file.text.empty() || !configuration::is_read(entry, start_up.list.channel_count)) continue;
    add_channel(start_up, entry);
  }
  for (configuration::OtherList const& other : start_up.list.others) {
    source_found(start_up, other.file, other.kind);
  }
}

void Loader::add_channel(StartUp& start_up, ListEntry const& entry) {
  auto const source = source_found(start_up, entry.file, ListKind::channel);
  if (source) add_channel(start_up, entry.index, *source);
}

void Loader::add_channel(StartUp& start_up, std::uint32_t number, SourceId source) {
  StartUpChannel& channel = start_up.channels.emplace_back();
  channel.index = number;
  channel.list = configuration::read_channel_list(sources_[source], source);
  add_default_programs(channel.list, default_channel_);
  channel.group = machine_.groups.size();
  LoadedGroup& group = machine_.groups.emplace_back();
  if (channel.list.name) group.name = channel.list.name->text;
  group.channel_list = source;
  group.pairs = channel.list.pairs;
  read_dynamics(group, look_ahead_of(*machine_.start_up, number, sources_));
  for (ChannelAxis const& named : channel.list.axes) {
    auto const axis = axis_numbered(machine_, named.number->number);
    bool const is_new = axis && std::find(group.axes.begin(), group.axes.end(), *axis) == group.axes.end();
    if (is_new) group.axes.push_back(*axis);
  }
  std::sort(group.axes.begin(), group.axes.end());
  for (configuration::ChannelProgram const& program : channel.list.programs) {
    load_program(start_up, channel, program);
  }
}

void Loader::load_program(StartUp& start_up, StartUpChannel const& channel,
                          configuration::ChannelProgram const& program) {
  ListSearch noted{.named = program.file,
                   .sought = program.is_streamed ? Sought::streamed_program : Sought::program,
                   .found = configuration::find_program(files_, machine_.path, channel.list, program)};
  if (noted.found) {
    auto const read = add_program(shown(noted.found->path), noted.found->path);
    if (auto const* const index = std::get_if<std::size_t>(&read)) {
      LoadedGroup& group = machine_.groups[channel.group];
      if (!runs_in(group, *index)) group.programs.push_back(*index);
    } else {
      noted.error = std::get<configuration::FileError>(read);
      noted.found.reset();
    }
  }
  if (!noted.found && !program.is_streamed) machine_.complete = false;
  // Several channels run a program of the default list.
  bool const is_noted =
      std::any_of(start_up.searches.begin(), start_up.searches.end(),
                  [&](ListSearch const& earlier) { return earlier.named.place == noted.named.place; });
  if (!is_noted) start_up.searches.push_back(std::move(noted));
}

void Loader::load_compensations(StartUp& start_up) {
  for (configuration::CompensationEntry const& entry : start_up.list.compensations) {
    if (!configuration::is_read(entry.list, start_up.list.compensation_count)) continue;
    auto const source = source_found(start_up, entry.list.file, ListKind::compensation);
    if (!source) continue;
    StartUpCompensation& compensation = start_up.compensations.emplace_back();
    compensation.entry = entry;
    for (configuration::ListedValue const& listed :
         configuration::listed_values(sources_[*source], *source)) {
      if (!configuration::match_name(listed.name, "kopf.achs_nr")) continue;
      compensation.own_axis = configuration::as_count(listed);
    }
  }
}

/// Programs use the channel's name. Two axes never get one name.
void Loader::name_axes(StartUp const& start_up) {
  std::set<std::string> taken;
  std::map<std::string, std::size_t> numbered;  // by name the first number that may be free
  for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
    LoadedAxis& axis = machine_.axes[i];
    EffectiveValue const& number = axis.merged.values.at("kopf.achs_nr");
    EffectiveValue const& own = axis.merged.values.at("kopf.log_achs_name");
    LocatedText const* const called =
        number.unusable ? nullptr : name_in_channels(start_up, number.value.number);
    std::string name(without_extension(file_name(machine_.lists[axis.list].name)));
    if (own.set() && !own.unusable && !own.value.text.empty()) name = own.value.text;
    if (i < start_up.program_names.size() && start_up.program_names[i]) {
      name = start_up.program_names[i]->text;
    }
    if (called != nullptr) name = called->text;
    std::string unique = name;
    std::size_t& count = numbered.try_emplace(name, 2).first->second;
    for (; !taken.insert(unique).second; ++count) unique = name + "_" + std::to_string(count);
    axis.name = std::move(unique);
  }
}

std::optional<std::size_t> Loader::axis_list_found(StartUp& start_up, LocatedText const& named) {
  ListSearch& noted = search(start_up, named, ListKind::axis);
  if (noted.found) {
    auto const list = add_list(noted.found->path, shown(noted.found->path));
    if (auto const* const index = std::get_if<std::size_t>(&list)) {
      noted.kind = machine_.lists[*index].list.kind;
      if (noted.kind == ListKind::axis) return *index;
    } else {
      noted.error = std::get<configuration::FileError>(list);
      noted.found.reset();
    }
  }
  machine_.complete = false;
  return std::nullopt;
}

std::optional<SourceId> Loader::source_found(StartUp& start_up, LocatedText const& named,
                                             std::optional<ListKind> wanted) {
  auto const source = source_of(start_up, named, wanted);
  machine_.complete = machine_.complete && source.has_value();
  return source;
}

std::optional<SourceId> Loader::source_of(StartUp& start_up, LocatedText const& named,
                                          std::optional<ListKind> wanted) {
  ListSearch& noted = search(start_up, named, wanted);
  if (!noted.found) return std::nullopt;
  std::string const key = key_of(noted.found->path);
  auto const known = others_by_path_.find(key);
  if (known != others_by_path_.end()) {
    noted.kind = configuration::decided_kind(sources_[known->second]);
    bool const is_wanted = !wanted || !noted.kind || noted.kind == wanted;
    return is_wanted ? std::optional(known->second) : std::nullopt;
  }
  std::variant<std::string, configuration::FileError> bytes = read_text(noted.found->path);
  if (auto const* const error = std::get_if<configuration::FileError>(&bytes)) {
    noted.error = *error;
    noted.found.reset();
    return std::nullopt;
  }
  machine_.files.push_back(noted.found->path);
  SourceId const source = add_text(noted.found->path, std::get<std::string>(std::move(bytes)));
  start_up.sources.push_back(source);
  others_by_path_.emplace(key, source);
  noted.kind = configuration::decided_kind(sources_[source]);
  bool const fits = !wanted || !noted.kind || noted.kind == wanted;
  std::optional<ListKind> const kind = wanted ? wanted : noted.kind;
  if (fits && kind) add_other_list(source, *kind, shown(noted.found->path));
  return fits ? std::optional(source) : std::nullopt;
}

ListSearch& Loader::search(StartUp& start_up, LocatedText const& named, std::optional<ListKind> wanted) {
  ListSearch& noted = start_up.searches.emplace_back();
  noted.named = named;
  noted.wanted = wanted;
  noted.found = configuration::find_list(files_, machine_.path, named.text);
  return noted;
}

std::string Loader::shown(std::string const& path) const {
  if (is_absolute(path) != is_absolute(machine_.path)) return std::string(file_name(path));
  auto const folder = system::path_of(machine_.path).parent_path();
  return system::name_of(system::path_of(path).lexically_relative(folder.empty() ? "." : folder));
}

}  // namespace axisc::validator
