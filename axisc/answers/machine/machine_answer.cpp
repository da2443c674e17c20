#include "axisc/answers/machine/machine_answer.hpp"

#include "axisc/answers/axis_type.hpp"
#include "axisc/answers/labels.hpp"
#include "validator/loading/loader.hpp"
#include "validator/loading/unreadable_file.hpp"
#include "validator/sentences.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/gantry.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence machine{"machine {machine}", "Maschine {machine}"};
constexpr Sentence cycle_time_at{"{time} ({place})", "{time} ({place})"};
constexpr Sentence no_cycle_time{"unknown; `--cycle-time` gives it", "unbekannt; `--cycle-time` gibt sie an"};
constexpr Sentence default_list{"default list", "Standardliste"};
constexpr Sentence default_channel_list{"default list of channels", "Standardliste der Kanäle"};
constexpr Sentence gantry{"gantry", "Gantry"};
constexpr Sentence named_in{"named in", "genannt in"};
constexpr Sentence master{"master", "Master"};
constexpr Sentence slave{"slave of {master}", "Slave von {master}"};
constexpr Sentence programs{"runs", "führt aus"};
constexpr Sentence lack{"missing or not usable", "fehlt oder ist nicht verwendbar"};
constexpr Sentence no_list{"the list \"{file}\" is not found", "die Liste „{file}“ ist nicht zu finden"};
constexpr Sentence no_program{"the program \"{file}\" is not found",
                              "das Programm „{file}“ ist nicht zu finden"};
constexpr Sentence other_kind{"the list \"{file}\" is of another kind",
                              "die Liste „{file}“ ist von anderer Art"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;
using validator::LoadedMachine;

namespace {

std::string name_of(LoadedMachine const& machine, std::size_t group) {
  auto const& name = machine.groups[group].name;
  return name.empty() ? std::to_string(group + 1) : name;
}

Names names_of(LoadedMachine const& machine, std::span<std::size_t const> axes) {
  Names names;
  for (auto const axis : axes) names.push_back(machine.axes[axis].name);
  return names;
}

Value gantry_of(LoadedMachine const& machine, std::size_t axis) {
  if (auto const master = validator::master_of(machine, axis)) {
    return Words(says::slave, {{"master", machine.axes[*master].name}});
  }
  bool const is_master = validator::GantryView(machine.axes[axis].merged.values).is_master() ||
                         validator::master_claim(machine, axis) != nullptr;
  return is_master ? Words(says::master) : Value();
}

/// What people see, and CSV.
Table axes_table(LoadedMachine const& machine, SourceSet const& sources) {
  Table table{.key = "understood_axes", .audience = Audience::people};
  for (std::size_t index = 0; index < machine.axes.size(); ++index) {
    auto const& axis = machine.axes[index];
    auto const* const drive = validator::drive_of(axis);
    auto const& number = axis.merged.values.at("kopf.achs_nr");
    bool const is_known = !number.unusable && (!machine.start_up || validator::has_own_number(axis));
    Names channels;
    for (std::size_t group = 0; group < machine.groups.size(); ++group) {
      auto const& axes = machine.groups[group].axes;
      if (std::find(axes.begin(), axes.end(), index) == axes.end()) continue;
      channels.push_back(name_of(machine, group));
    }
    add_row(
        table,
        {{"name", labels::axis, axis.name},
         {"number", labels::number, is_known ? Value(exact(number.value.number)) : Value("?")},
         {"list", labels::list, machine.lists[axis.list].name},
         {"type", labels::type, axis_type_symbol(axis.type)},
         {"drive", labels::drive, drive == nullptr ? Value("?") : validator::drive_name(*drive)},
         {"channel", labels::channel, channels},
         {"gantry", says::gantry, gantry_of(machine, index)},
         {"named_in", says::named_in,
          machine.start_up
              ? place_text(machine.start_up->list.axes[machine.start_up->entries[index]].file.place, sources)
              : machine.path}});
  }
  return table;
}

Table channels_table(LoadedMachine const& machine) {
  Table table{.key = {}, .audience = Audience::people};
  for (std::size_t i = 0; i < machine.groups.size(); ++i) {
    auto const& group = machine.groups[i];
    Names programs;
    for (auto const program : group.programs) programs.push_back(machine.programs[program].name);
    add_row(table, {shown(labels::channel, name_of(machine, i)),
                    shown(labels::axes, names_of(machine, group.axes)), shown(says::programs, programs)});
  }
  return table;
}

Table lacks_table(LoadedMachine const& machine, SourceSet const& sources) {
  Table table{.key = {}, .audience = Audience::people};
  for (auto const& [place, reason] : lacks_of(machine, sources)) {
    add_row(table, {shown(says::named_in, place), shown(says::lack, reason)});
  }
  return table;
}

/// An array of the machine file.
Sections entries(std::string key, std::vector<std::vector<Field>> all) {
  Sections sections{.key = std::move(key), .items = {}};
  for (auto& fields : all) {
    sections.items.push_back({.key = {},
                              .title = {},
                              .blocks = {},
                              .identity = std::move(fields),
                              .audience = Audience::programs});
  }
  return sections;
}

Sections file_axes(LoadedMachine const& machine, SourceSet const& sources) {
  std::vector<std::vector<Field>> axes;
  for (auto const& axis : machine.axes) {
    auto& fields = axes.emplace_back();
    fields = {data("name", axis.name), data("list", sources[machine.lists[axis.list].list.source].name())};
    if (axis.drive) fields.push_back(data("drive", axis.drive->text));
    if (axis.position_control != machine::PositionController::unknown) {
      bool const in_drive = axis.position_control == machine::PositionController::drive;
      fields.push_back(data("position_control", in_drive ? "drive" : "cnc"));
    }
    if (axis.type != validator::axis_type_of(axis.merged.values)) {
      fields.push_back(data("type", axis_type_symbol(axis.type)));
    }
  }
  return entries("axes", std::move(axes));
}

Sections file_groups(LoadedMachine const& machine, SourceSet const& sources) {
  bool const is_project = machine.start_up && machine.start_up->is_project;
  std::vector<std::vector<Field>> groups;
  for (auto const& group : machine.groups) {
    auto& fields = groups.emplace_back();
    if (!group.name.empty()) fields.push_back(data("name", group.name));
    fields.push_back(data("axes", names_of(machine, group.axes)));
    Names programs;
    for (auto const program : group.programs) programs.push_back(machine.programs[program].path);
    if (!programs.empty()) fields.push_back(data("programs", std::move(programs)));
    // A project has its lists inside.
    if (group.channel_list && !is_project) {
      fields.push_back(data("channel_list", sources[*group.channel_list].name()));
    }
    if (group.look_ahead_said) {
      fields.push_back(data("look_ahead_blocks", group.dynamics.look_ahead_blocks));
    }
  }
  return entries("groups", std::move(groups));
}

/// What a machine file says about gantries; the rest is in the lists.
Sections file_gantries(LoadedMachine const& machine) {
  std::vector<std::vector<Field>> gantries;
  auto const& claims = machine.gantry_claims;
  for (std::size_t i = 0; i < claims.size();) {
    auto const& master = machine.axes[claims[i].axis].name;
    Names slaves;
    for (++i; i < claims.size() && claims[i].master; ++i) slaves.push_back(machine.axes[claims[i].axis].name);
    gantries.push_back({data("master", master), data("slaves", std::move(slaves))});
  }
  return entries("gantries", std::move(gantries));
}

Facts facts_of(LoadedMachine const& machine, SourceSet const& sources) {
  Facts facts{{data("machine", machine.name)}};
  auto& fields = facts.fields;
  Value time = Words(says::no_cycle_time);
  if (machine.cycle_time) {
    auto const cycle = exact(machine.cycle_time->microseconds(), Unit::microsecond);
    fields.push_back(data("cycle_time_us", cycle));
    bool const is_listed = machine.start_up && machine.start_up->real_time.cycle_time == machine.cycle_time;
    time = cycle;
    if (is_listed) {
      auto const place = place_text(machine.start_up->real_time.place, sources);
      time = Words(says::cycle_time_at, {{"time", cycle}, {"place", place}});
    }
  }
  fields.push_back(shown(labels::cycle_time, std::move(time)));
  if (machine.default_list) {
    auto const& list = machine.lists[*machine.default_list];
    fields.push_back(data("default_list", sources[list.list.source].name()));
    fields.push_back(shown(says::default_list, list.name));
  }
  bool const is_project = machine.start_up && machine.start_up->is_project;
  if (machine.default_channel_list && !is_project) {
    auto const& path = sources[*machine.default_channel_list].name();
    fields.push_back(data("default_channel_list", path));
    fields.push_back(shown(says::default_channel_list, std::string(validator::file_name(path))));
  }
  return facts;
}

/// Why a list or program is of no use; none if it is.
std::optional<Words> reason_of(validator::ListSearch const& search) {
  using validator::Sought;
  if (search.sought == Sought::streamed_program) return std::nullopt;
  auto const& text = search.named.text;
  if (search.sought == Sought::unnamed_list) {
    return Words(validator::says::unnamed_list, {{"parameter", text}});
  }
  if (search.error) return Words(validator::sentence_of(*search.error), {{"file", text}});
  bool const is_program = search.sought == Sought::program;
  if (!search.found) return Words(is_program ? says::no_program : says::no_list, {{"file", text}});
  bool const fits = !search.wanted || !search.kind || search.wanted == search.kind;
  if (fits) return std::nullopt;
  return Words(says::other_kind, {{"file", text}});
}

}  // namespace

std::string place_text(Place const& place, SourceSet const& sources) {
  auto const& source = sources[place.source];
  return source.name() + ":" + std::to_string(source.position(place.span.begin).line);
}

std::vector<MachineLack> lacks_of(LoadedMachine const& machine, SourceSet const& sources) {
  std::vector<MachineLack> lacks;
  for (auto const& finding : machine.findings) {
    lacks.push_back({place_text(*finding.place, sources), finding.message});
  }
  if (!machine.start_up) return lacks;
  for (auto const& search : machine.start_up->searches) {
    if (auto reason = reason_of(search)) {
      lacks.push_back({place_text(search.named.place, sources), std::move(*reason)});
    }
  }
  return lacks;
}

Document machine_answer(LoadedMachine const& machine, SourceSet const& sources) {
  Document answer{
      .version = 0,
      .title = Words(says::machine, {{"machine", machine.name}}),
      .blocks = {facts_of(machine, sources), axes_table(machine, sources), channels_table(machine),
                 lacks_table(machine, sources), file_axes(machine, sources), file_groups(machine, sources)},
      .csv_table = "understood_axes"};
  auto& blocks = answer.blocks;
  if (!machine.gantry_claims.empty()) blocks.emplace_back(file_gantries(machine));
  Names filter_sets;
  for (auto const& set : machine.filter_sets) filter_sets.push_back(set.text);
  if (!filter_sets.empty()) blocks.emplace_back(Facts{{data("filter_sets", std::move(filter_sets))}});
  if (machine.inch) blocks.emplace_back(Facts{{data("inch", true)}});
  return answer;
}

}  // namespace axisc
