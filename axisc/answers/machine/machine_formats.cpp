#include "axisc/answers/machine/machine_formats.hpp"

#include "axisc/answers/text_table.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/loading/unreadable_file.hpp"
#include "validator/sentences.hpp"
#include "validator/views/drive.hpp"
#include "validator/views/gantry.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence heading{"machine {machine}, axes: {axes}", "Maschine {machine}, Achsen: {axes}"};
constexpr Sentence cycle_time{"NC cycle time {time} µs", "NC-Zykluszeit {time} µs"};
constexpr Sentence cycle_time_at{"NC cycle time {time} µs ({place})", "NC-Zykluszeit {time} µs ({place})"};
constexpr Sentence no_cycle_time{"NC cycle time unknown; `--cycle-time` gives it",
                                 "NC-Zykluszeit unbekannt; `--cycle-time` gibt sie an"};
constexpr Sentence default_list{"default list {list}", "Standardliste {list}"};
constexpr Sentence column_axis{"axis", "Achse"};
constexpr Sentence column_number{"number", "Nummer"};
constexpr Sentence column_list{"list", "Liste"};
constexpr Sentence column_type{"type", "Typ"};
constexpr Sentence column_drive{"drive", "Antrieb"};
constexpr Sentence column_channel{"channel", "Kanal"};
constexpr Sentence column_gantry{"gantry", "Gantry"};
constexpr Sentence column_place{"named in", "genannt in"};
constexpr Sentence type_translatory{"translatory", "translatorisch"};
constexpr Sentence type_rotary{"rotary", "rotatorisch"};
constexpr Sentence type_spindle{"spindle", "Spindel"};
constexpr Sentence gantry_master{"master", "Master"};
constexpr Sentence gantry_slave{"slave of {master}", "Slave von {master}"};
constexpr Sentence channel{"channel {name}: {axes}", "Kanal {name}: {axes}"};
constexpr Sentence channel_programs{"runs {programs}", "führt aus: {programs}"};
constexpr Sentence no_list{"the list \"{file}\" is not found", "die Liste „{file}“ ist nicht zu finden"};
constexpr Sentence no_program{"the program \"{file}\" is not found",
                              "das Programm „{file}“ ist nicht zu finden"};
constexpr Sentence other_kind{"the list \"{file}\" is of another kind",
                              "die Liste „{file}“ ist von anderer Art"};

}  // namespace axisc::says

namespace axisc {

namespace {

using nlohmann::ordered_json;
using validator::LoadedAxis;
using validator::LoadedMachine;

class MachineText {
 public:
  MachineText(LoadedMachine const& machine, SourceSet const& sources, Language language)
      : machine_(machine), sources_(sources), language_(language) {}

  std::string write() const {
    std::string text =
        line(says::heading, {{"machine", machine_.name}, {"axes", std::to_string(machine_.axes.size())}}) +
        time();
    if (machine_.default_list) {
      text += line(says::default_list, {{"list", machine_.lists[*machine_.default_list].name}});
    }
    auto const lacking = what_lacks();
    return text + "\n" + axes() + channels() + (lacking.empty() ? "" : "\n" + lacking);
  }

  /// What the machine lacks, a line each.
  [[nodiscard]] std::string what_lacks() const {
    std::string text;
    auto const add = [&](Place const& place, std::string const& reason) {
      if (reason.empty()) return;
      text += place_text(place) + ": " + reason + "\n";
    };
    for (auto const& finding : machine_.findings) add(*finding.place, render(finding.message, language_));
    if (!machine_.start_up) return text;
    for (auto const& search : machine_.start_up->searches) add(search.named.place, lacks(search));
    return text;
  }

 private:
  [[nodiscard]] std::string say(SentenceRef sentence, std::vector<Argument> arguments = {}) const {
    return render({.sentence = sentence, .arguments = std::move(arguments)}, language_);
  }
  [[nodiscard]] std::string line(SentenceRef sentence, std::vector<Argument> arguments = {}) const {
    return say(sentence, std::move(arguments)) + "\n";
  }
  [[nodiscard]] std::string place_text(Place const& place) const {
    SourceText const& source = sources_[place.source];
    return source.name() + ":" + std::to_string(source.position(place.span.begin).line);
  }

  [[nodiscard]] std::string time() const {
    if (!machine_.cycle_time) return line(says::no_cycle_time);
    std::vector<Argument> arguments{{"time", exact_number(machine_.cycle_time->microseconds())}};
    bool const is_listed =
        machine_.start_up && machine_.start_up->real_time.cycle_time == machine_.cycle_time;
    if (!is_listed) return line(says::cycle_time, std::move(arguments));
    arguments.push_back({"place", place_text(machine_.start_up->real_time.place)});
    return line(says::cycle_time_at, std::move(arguments));
  }

  [[nodiscard]] std::string axes() const {
    std::vector<std::vector<std::string>> rows{{say(says::column_axis), say(says::column_number),
                                                say(says::column_list), say(says::column_type),
                                                say(says::column_drive), say(says::column_channel),
                                                say(says::column_gantry), say(says::column_place)}};
    for (std::size_t index = 0; index < machine_.axes.size(); ++index) {
      LoadedAxis const& axis = machine_.axes[index];
      auto const* const drive = validator::drive_of(axis);
      validator::EffectiveValue const& number = axis.merged.values.at("kopf.achs_nr");
      rows.push_back({axis.name, number.unusable ? "?" : format_exact(number.value.number),
                      machine_.lists[axis.list].name, say(type(axis.type)),
                      drive == nullptr ? "?" : validator::drive_name(*drive).in(language_), channel_of(index),
                      gantry_of(index), named_in(index)});
    }
    return text_table(rows, 0);
  }

  static SentenceRef type(machine::AxisType type) {
    if (type == machine::AxisType::spindle) return says::type_spindle;
    return type == machine::AxisType::rotary ? says::type_rotary : says::type_translatory;
  }

  [[nodiscard]] std::string name_of_group(std::size_t group) const {
    auto const& name = machine_.groups[group].name;
    return name.empty() ? std::to_string(group + 1) : name;
  }

  [[nodiscard]] std::string channel_of(std::size_t axis) const {
    std::string names;
    for (std::size_t group = 0; group < machine_.groups.size(); ++group) {
      auto const& axes = machine_.groups[group].axes;
      if (std::find(axes.begin(), axes.end(), axis) == axes.end()) continue;
      names += (names.empty() ? "" : ", ") + name_of_group(group);
    }
    return names.empty() ? "-" : names;
  }

  [[nodiscard]] std::string gantry_of(std::size_t axis) const {
    if (auto const master = validator::master_of(machine_, axis)) {
      return say(says::gantry_slave, {{"master", machine_.axes[*master].name}});
    }
    bool const is_master = validator::GantryView(machine_.axes[axis].merged.values).is_master() ||
                           validator::master_claim(machine_, axis) != nullptr;
    return is_master ? say(says::gantry_master) : "-";
  }

  [[nodiscard]] std::string named_in(std::size_t axis) const {
    if (!machine_.start_up) return machine_.path;
    auto const& start_up = *machine_.start_up;
    return place_text(start_up.list.axes[start_up.entries[axis]].file.place);
  }

  [[nodiscard]] std::string channels() const {
    std::string text;
    for (std::size_t i = 0; i < machine_.groups.size(); ++i) {
      auto const& group = machine_.groups[i];
      std::string names;
      for (auto const axis : group.axes) names += (names.empty() ? "" : ", ") + machine_.axes[axis].name;
      text += "\n" + line(says::channel, {{"name", name_of_group(i)}, {"axes", names.empty() ? "-" : names}});
      std::string programs;
      for (auto const program : group.programs) {
        programs += (programs.empty() ? "" : ", ") + machine_.programs[program].name;
      }
      if (!programs.empty()) text += "  " + line(says::channel_programs, {{"programs", programs}});
    }
    return text;
  }

  [[nodiscard]] std::string lacks(validator::ListSearch const& search) const {
    if (search.sought == validator::Sought::streamed_program) return {};
    if (search.sought == validator::Sought::unnamed_list) {
      return say(validator::says::unnamed_list, {{"parameter", search.named.text}});
    }
    std::vector<Argument> arguments{{"file", search.named.text}};
    if (search.error) return say(validator::sentence_of(*search.error), std::move(arguments));
    bool const is_program = search.sought == validator::Sought::program;
    if (!search.found) return say(is_program ? says::no_program : says::no_list, std::move(arguments));
    bool const fits = !search.wanted || !search.kind || search.wanted == search.kind;
    return fits ? std::string() : say(says::other_kind, std::move(arguments));
  }

  LoadedMachine const& machine_;
  SourceSet const& sources_;
  Language language_;
};

char const* position_control_word(machine::PositionController controller) {
  return controller == machine::PositionController::drive ? "drive" : "cnc";
}

char const* type_letter(machine::AxisType type) {
  if (type == machine::AxisType::spindle) return "S";
  return type == machine::AxisType::rotary ? "R" : "T";
}

ordered_json axis_json(LoadedMachine const& machine, SourceSet const& sources, LoadedAxis const& axis) {
  ordered_json json{{"name", axis.name}, {"list", sources[machine.lists[axis.list].list.source].name()}};
  if (axis.drive) json["drive"] = axis.drive->text;
  if (axis.position_control != machine::PositionController::unknown) {
    json["position_control"] = position_control_word(axis.position_control);
  }
  if (axis.type != validator::axis_type_of(axis.merged.values)) json["type"] = type_letter(axis.type);
  return json;
}

/// What a machine file says about gantries; the rest is in the lists.
ordered_json gantries_json(LoadedMachine const& machine) {
  ordered_json gantries = ordered_json::array();
  for (auto const& claim : machine.gantry_claims) {
    auto const& name = machine.axes[claim.axis].name;
    if (!claim.master) {
      gantries.push_back({{"master", name}, {"slaves", ordered_json::array()}});
    } else {
      gantries.back()["slaves"].push_back(name);
    }
  }
  return gantries;
}

}  // namespace

std::string machine_text(LoadedMachine const& machine, SourceSet const& sources, Language language) {
  return MachineText(machine, sources, language).write();
}

std::string machine_lacks(LoadedMachine const& machine, SourceSet const& sources, Language language) {
  return MachineText(machine, sources, language).what_lacks();
}

std::string machine_json(LoadedMachine const& machine, SourceSet const& sources) {
  ordered_json json{{"machine", machine.name}};
  if (machine.cycle_time) json["cycle_time_us"] = machine.cycle_time->microseconds();
  if (machine.default_list) {
    json["default_list"] = sources[machine.lists[*machine.default_list].list.source].name();
  }
  json["axes"] = ordered_json::array();
  for (auto const& axis : machine.axes) json["axes"].push_back(axis_json(machine, sources, axis));
  json["groups"] = ordered_json::array();
  for (auto const& group : machine.groups) {
    ordered_json entry = ordered_json::object();
    if (!group.name.empty()) entry["name"] = group.name;
    entry["axes"] = ordered_json::array();
    for (auto const axis : group.axes) entry["axes"].push_back(machine.axes[axis].name);
    for (auto const program : group.programs) entry["programs"].push_back(machine.programs[program].path);
    json["groups"].push_back(std::move(entry));
  }
  if (!machine.gantry_claims.empty()) json["gantries"] = gantries_json(machine);
  for (auto const& set : machine.filter_sets) json["filter_sets"].push_back(set.text);
  if (machine.inch) json["inch"] = true;
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace axisc
