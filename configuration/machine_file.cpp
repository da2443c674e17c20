#include "configuration/machine_file.hpp"

#include "configuration/filter_set_limit.hpp"
#include "configuration/json_check.hpp"
#include "configuration/located_json.hpp"
#include "configuration/machine/drive_type.hpp"
#include "configuration/sentences.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/joined.hpp"
#include "diagnostics/utf8.hpp"
#include "schema/closest_word.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace axisc::configuration::says {

constexpr Sentence json{"the machine file is not valid JSON here",
                        "die Maschinendatei ist hier kein gültiges JSON"};
constexpr Sentence json_end{"the machine file ends before it is complete",
                            "die Maschinendatei endet, bevor sie vollständig ist"};
constexpr Sentence no_axes{"a machine needs at least one axis",
                           "eine Maschine braucht mindestens eine Achse"};
constexpr Sentence repeated_axis{"the axis name \"{name}\" is used twice",
                                 "der Achsname \"{name}\" kommt zweimal vor"};
constexpr Sentence known_axes{"its axes: {names}", "ihre Achsen: {names}"};
constexpr Sentence unknown_axis{"this machine has no axis \"{name}\"",
                                "diese Maschine hat keine Achse \"{name}\""};

constexpr Sentence repeated_group{"the group name \"{name}\" is used twice",
                                  "der Gruppenname \"{name}\" kommt zweimal vor"};
constexpr Sentence grouped_twice{"axis \"{name}\" is in a group already",
                                 "Achse \"{name}\" ist schon in einer Gruppe"};
constexpr Sentence repeated_slave{"axis \"{name}\" is the slave of a gantry already",
                                  "Achse \"{name}\" ist schon Slaveachse eines Gantryverbunds"};
constexpr Sentence own_slave{"axis \"{name}\" cannot be its own slave",
                             "Achse \"{name}\" kann nicht ihre eigene Slaveachse sein"};
constexpr Sentence circular_gantry{R"(axis "{name}" cannot follow "{master}", which follows it)",
                                   R"(Achse "{name}" kann nicht "{master}" folgen, die ihr selbst folgt)"};
constexpr Sentence ethercat{
    R"(EtherCAT is the bus: "CANopen" where the drive speaks CoE, "SERCOS" where it speaks SoE)",
    "EtherCAT ist der Bus: \"CANopen\" für Antriebe mit CoE, \"SERCOS\" für solche mit SoE"};
constexpr Sentence json_fix{"write \"{replacement}\"", "\"{replacement}\" schreiben"};
constexpr Sentence json_first{"first here", "zuerst hier"};

}  // namespace axisc::configuration::says

namespace axisc::configuration {
namespace {

using Kind = JsonShapeKind;
using enum JsonPresence;

constexpr auto drive_words = [] {
  std::array<std::string_view, machine::drive_types.size()> words;
  std::transform(machine::drive_types.begin(), machine::drive_types.end(), words.begin(),
                 [](machine::DriveType const& drive) { return drive.word; });
  return words;
}();
constexpr std::array<std::string_view, 2> position_controls = {"drive", "cnc"};
constexpr std::array<std::string_view, 3> axis_types = {"T", "R", "S"};

constexpr JsonShape drive_shape{.words = drive_words, .ignores_case = true};
constexpr JsonShape position_control_shape{.words = position_controls, .ignores_case = true};
constexpr JsonShape axis_type_shape{.words = axis_types, .ignores_case = true};

void store_axis_type(JsonDocument const& /*document*/, JsonValue const& value, MachineFileAxis& axis) {
  axis.type = ascii::equal_ignoring_case(value.string, "T")   ? machine::AxisType::translatory
              : ascii::equal_ignoring_case(value.string, "R") ? machine::AxisType::rotary
                                                              : machine::AxisType::spindle;
}

/// As long as AX8000 drives delay at most (0x3062:02: 10 ms), and ten times that for others.
constexpr JsonShape drive_delay_shape{.kind = Kind::number, .lowest = 0, .highest = 100'000};

void store_drive_delay(JsonDocument const& /*document*/, JsonValue const& value, MachineFileAxis& axis) {
  axis.drive_delay_us = value.number;
}

constexpr std::array axis_keys = {
    JsonKey{"name", &visible_name_shape, required, "Name of the axis, unique in the machine.",
            into<&MachineFileAxis::name>},
    JsonKey{"list", &json_text, required, "Its parameter list, relative to the machine file.",
            into<&MachineFileAxis::list>},
    JsonKey{"drive", &drive_shape, optional, "Type of the drive; wins over kenngr.antr_typ of the list.",
            into<&MachineFileAxis::drive>},
    JsonKey{"position_control", &position_control_shape, optional, "Where the position is controlled.",
            into<&MachineFileAxis::position_control>},
    JsonKey{"type", &axis_type_shape, optional,
            "Translatory, rotary or spindle; wins over kenngr.achs_typ of the list.", by<store_axis_type>},
    JsonKey{"drive_delay_us", &drive_delay_shape, optional,
            "What the drive itself delays, in microseconds, for the delay budget.", by<store_drive_delay>}};
constexpr JsonShape axis_shape{.kind = Kind::object, .title = "Axis", .keys = axis_keys};
constexpr JsonShape axes_shape{
    .kind = Kind::list, .items = &axis_shape, .fewest = 1, .sentence = says::no_axes};

/// As large as the buffer of FCT_LOOK_AHEAD_CUSTOM may be.
constexpr JsonShape look_ahead_shape{.kind = Kind::whole_number, .lowest = 10, .highest = 10000};

void store_look_ahead(JsonDocument const& /*document*/, JsonValue const& value, MachineFileGroup& group) {
  group.look_ahead_blocks = static_cast<std::uint32_t>(value.number);
}

constexpr std::array group_keys = {
    JsonKey{"name", &visible_name_shape, optional, "Name of the group, for messages.",
            into<&MachineFileGroup::name>},
    JsonKey{"axes", &json_texts, required, "Names of the axes that move together.",
            into<&MachineFileGroup::axes>},
    JsonKey{"programs", &json_texts, optional, "Programs that are checked against this group alone.",
            into<&MachineFileGroup::programs>},
    JsonKey{"channel_list", &json_text, optional,
            "The channel's parameter list: how the control plans the path of the group.",
            into<&MachineFileGroup::channel_list>},
    JsonKey{"look_ahead_blocks", &look_ahead_shape, optional,
            "Blocks that the control looks ahead, where the channel list does not say it.",
            by<store_look_ahead>}};
constexpr JsonShape group_shape{.kind = Kind::object, .title = "Group of axes", .keys = group_keys};
constexpr JsonShape groups_shape{.kind = Kind::list, .items = &group_shape};

constexpr std::array gantry_keys = {
    JsonKey{"master", &json_text, required, "Name of the leading axis.", into<&MachineFileGantry::master>},
    JsonKey{"slaves", &json_texts, required, "Names of the axes that follow.",
            into<&MachineFileGantry::slaves>}};
constexpr JsonShape gantry_shape{.kind = Kind::object, .title = "Gantry", .keys = gantry_keys};
constexpr JsonShape gantries_shape{.kind = Kind::list, .items = &gantry_shape};

constexpr JsonShape filter_sets_shape{.kind = Kind::list, .items = &json_text, .most = most_filter_sets};

constexpr std::array machine_keys = {
    JsonKey{"machine", &visible_name_shape, optional, "Name of the machine.", into<&MachineFile::machine>},
    JsonKey{"cycle_time_us", &json_cycle_time, optional, "Cycle time of the control in microseconds.",
            into<&MachineFile::cycle_time>},
    JsonKey{"default_list", &json_text, optional,
            "List with the values that the lists of the axes leave out.", into<&MachineFile::default_list>},
    JsonKey{"default_channel_list", &json_text, optional,
            "Parameter list with the values that the channel lists leave out.",
            into<&MachineFile::default_channel_list>},
    JsonKey{"axes", &axes_shape, required, "All axes of the machine.", into<&MachineFile::axes>},
    JsonKey{"groups", &groups_shape, optional, "Axes that move together.", into<&MachineFile::groups>},
    JsonKey{"gantries", &gantries_shape, optional, "Axes that follow another one.",
            into<&MachineFile::gantries>},
    JsonKey{"programs", &json_texts, optional, "Programs that are checked against every group.",
            into<&MachineFile::programs>},
    JsonKey{"filter_sets", &filter_sets_shape, optional,
            "#FILTER and #VIB GUARD commands that programs may use beside those of `programs`.",
            into<&MachineFile::filter_sets>},
    JsonKey{"inch", &json_flag, optional, "Lengths in programs are inches.", into<&MachineFile::inch>},
    JsonKey{"report", &machine_file_report_shape, optional,
            "What the cover of `axisc report` says; its options take precedence.",
            into<&MachineFile::report>}};
}  // namespace

constexpr JsonShape machine_file_shape{
    .kind = Kind::object, .title = "Machine of axisc", .keys = machine_keys};

namespace {

/// A machine file that was written on Windows names the same files everywhere.
void use_slashes(MachineFile& machine) {
  auto const use = [](LocatedText& name) { std::replace(name.text.begin(), name.text.end(), '\\', '/'); };
  if (machine.default_list) use(*machine.default_list);
  if (machine.default_channel_list) use(*machine.default_channel_list);
  for (MachineFileAxis& axis : machine.axes) use(axis.list);
  for (LocatedText& program : machine.programs) use(program);
  for (MachineFileGroup& group : machine.groups) {
    for (LocatedText& program : group.programs) use(program);
    if (group.channel_list) use(*group.channel_list);
  }
}

class MachineFileReader {
 public:
  MachineFileReader(SourceText const& text, SourceId source, std::deque<Finding>& findings)
      : text_(text), source_(source), findings_(findings) {}

  void broken(JsonError const& error) {
    Finding& finding = add(error.span, {error.span.empty() ? says::json_end : says::json});
    finding.label = error.reason;
  }

  MachineFile read(JsonDocument const& document) {
    JsonCheck const check = check_json(document, machine_file_shape);
    for (JsonProblem const& problem : check.problems) tell(problem);
    MachineFile machine;
    if (!check.readable.front()) return machine;
    JsonReading(document, check.readable, source_).fill(machine_file_shape, document.root(), &machine);
    use_slashes(machine);
    require_distinct_axes(machine.axes);
    for (MachineFileGroup& group : machine.groups) {
      require_axes(group.axes);
      if (group.name) require_new(group_names_, *group.name, says::repeated_group);
      std::erase_if(group.axes, [this](LocatedText const& axis) {
        return !require_new(grouped_axes_, axis, says::grouped_twice);
      });
    }
    for (MachineFileGantry& gantry : machine.gantries) {
      if (!gantry.master.text.empty() && !is_axis(gantry.master)) gantry.master.text.clear();
      require_axes(gantry.slaves);
      std::erase_if(gantry.slaves, [&](LocatedText const& slave) { return !follows(gantry.master, slave); });
    }
    std::erase_if(machine.gantries, [](MachineFileGantry const& each) { return each.master.text.empty(); });
    return machine;
  }

 private:
  Finding& add(Span span, Message message) {
    Finding& finding = findings_.emplace_back();
    finding.code = machine_file_code;
    finding.place = Place{.source = source_, .span = span};
    finding.message = std::move(message);
    return finding;
  }

  void tell(JsonProblem const& problem) {
    Finding& finding = add(problem.span, problem.message);
    suggest(finding, problem.suggestion);
    if (!problem.number.empty()) {
      finding.fix =
          write({says::json_write_number, {{"replacement", problem.number}}}, *finding.place, problem.number);
    }
    if (ascii::equal_ignoring_case(text_.slice(problem.span), "\"EtherCAT\"")) {
      finding.help.push_back({says::ethercat});
    }
    if (!problem.known_keys.empty()) {
      finding.notes.push_back({says::json_known_keys, {{"keys", problem.known_keys}}});
    }
    if (problem.first) relate(finding, {.source = source_, .span = *problem.first});
  }

  static void relate(Finding& finding, Place first) {
    finding.related.push_back({.place = first, .message = {says::json_first}});
  }

  static void suggest(Finding& finding, std::string const& word) {
    if (word.empty()) return;
    finding.help.push_back({says::json_did_you_mean, {{"suggestion", word}}});
    finding.fix = write({says::json_fix, {{"replacement", word}}}, *finding.place, '"' + word + '"');
  }

  static Fix write(Message title, Place place, std::string text) {
    Fix fix;
    fix.title = std::move(title);
    fix.edits.push_back({.place = place, .text = std::move(text)});
    return fix;
  }

  /// Leaves out repeated axes and those without name or list; afterwards all names are known.
  void require_distinct_axes(std::vector<MachineFileAxis>& axes) {
    auto const leave_out = [&](MachineFileAxis const& axis) {
      if (axis.name.text.empty()) return true;
      auto const [first, is_new] = axis_names_.try_emplace(axis.name.text, axis.name.place);
      if (is_new) return axis.list.text.empty();
      Message message{says::repeated_axis, {{"name", axis.name.text}}};
      relate(add(axis.name.place.span, std::move(message)), first->second);
      return true;
    };
    std::vector<MachineFileAxis> kept;
    for (MachineFileAxis& axis : axes) {
      if (!leave_out(axis)) kept.push_back(std::move(axis));
    }
    axes = std::move(kept);
  }

  bool is_axis(LocatedText const& name) {
    if (axis_names_.contains(name.text)) return true;
    std::vector<std::string_view> known;
    for (auto const& [axis, place] : axis_names_) known.push_back(axis);
    Message message{says::unknown_axis, {{"name", name.text}}};
    Finding& finding = add(name.place.span, std::move(message));
    suggest(finding, std::string(schema::closest_word(name.text, known)));
    if (!finding.fix && !known.empty()) {
      finding.notes.push_back({says::known_axes, {{"names", joined(known)}}});
    }
    return false;
  }

  /// False for a name that `known` has already.
  bool require_new(std::map<std::string, Place>& known, LocatedText const& name, SentenceRef sentence) {
    auto const [first, is_new] = known.try_emplace(name.text, name.place);
    if (is_new) return true;
    Message message{sentence, {{"name", name.text}}};
    relate(add(name.place.span, std::move(message)), first->second);
    return false;
  }

  /// False where `slave` cannot follow `master`.
  bool follows(LocatedText const& master, LocatedText const& slave) {
    if (master.text.empty()) return true;
    if (slave.text == master.text) {
      add(slave.place.span, {says::own_slave, {{"name", slave.text}}});
      return false;
    }
    if (!require_new(slaves_, slave, says::repeated_slave)) return false;
    // No master is its own, so that every chain of them ends.
    for (auto leader = masters_.find(master.text); leader != masters_.end();
         leader = masters_.find(leader->second)) {
      if (leader->second != slave.text) continue;
      add(slave.place.span, {says::circular_gantry, {{"name", slave.text}, {"master", master.text}}});
      return false;
    }
    masters_.emplace(slave.text, master.text);
    return true;
  }

  void require_axes(std::vector<LocatedText>& names) {
    std::erase_if(names, [this](LocatedText const& name) { return !is_axis(name); });
  }

  SourceText const& text_;
  SourceId source_;
  std::deque<Finding>& findings_;
  std::map<std::string, Place> axis_names_, group_names_, grouped_axes_, slaves_;
  std::map<std::string, std::string> masters_;  ///< of slaves
};

}  // namespace

MachineFile read_machine_file(SourceSet const& sources, SourceId source, std::deque<Finding>& findings) {
  SourceText const& text = sources[source];
  MachineFileReader reader(text, source, findings);
  auto const parsed = parse_json(text.bytes(), text.text_begin());
  if (auto const* const error = std::get_if<JsonError>(&parsed)) {
    reader.broken(*error);
    return {};
  }
  return reader.read(std::get<JsonDocument>(parsed));
}

bool looks_like_machine_file(std::string_view bytes) {
  bytes = without_byte_order_mark(bytes);
  std::size_t const first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  return bytes[first] == '{' || bytes.find("\"axes\"") != std::string_view::npos;
}

}  // namespace axisc::configuration
