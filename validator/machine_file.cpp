#include "validator/machine_file.hpp"

#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"
#include "schema/closest_word.hpp"
#include "validator/drive.hpp"
#include "validator/located_json.hpp"
#include "validator/rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace axisc::validator {
namespace {

constexpr std::array<std::string_view, 9> machine_keys = {"machine",  "cycle_time_us", "default_list",
                                                          "axes",     "groups",        "gantries",
                                                          "programs", "filter_sets",   "inch"};
constexpr std::array<std::string_view, 5> axis_keys = {"name", "list", "drive", "position_control", "type"};
constexpr std::array<std::string_view, 3> group_keys = {"name", "axes", "programs"};
constexpr std::array<std::string_view, 2> gantry_keys = {"master", "slaves"};

constexpr std::array<std::string_view, 2> position_controls = {"drive", "cnc"};
constexpr std::array<std::string_view, 3> axis_types = {"T", "R", "S"};

using Words = std::vector<std::string_view>;

template <std::size_t size>
Words words(std::array<std::string_view, size> const& array) {
  return {array.begin(), array.end()};
}

Words drive_words() {
  Words list;
  for (DriveType const& drive : drive_types) list.push_back(drive.word);
  return list;
}

std::string joined(Words const& list) {
  std::string text;
  for (std::string_view const word : list) text.append(text.empty() ? "" : ", ").append(word);
  return text;
}

class MachineFileReader {
 public:
  MachineFileReader(SourceId source, ReportedFindings& findings)
      : source_(source), report_(findings, *find_rule(Code{4020})) {}

  void broken(JsonError const& error) {
    add(error.span, error.span.empty() ? Text::ax4020_json_end : Text::ax4020_json);
  }

  MachineFile read(JsonDocument const& document) {
    document_ = &document;
    MachineFile machine;
    JsonValue const& root = document.root();
    if (root.kind != JsonKind::object) {
      add(root.span, Text::ax4020_object);
      return machine;
    }
    Object const object(*this, root, words(machine_keys));
    machine.machine = text(object, "machine");
    machine.cycle_time = cycle_time(object);
    machine.default_list = text(object, "default_list");
    if (JsonValue const* const inch = object.find("inch")) {
      if (inch->kind != JsonKind::boolean) add(inch->span, Text::ax4020_flag, {{"key", "inch"}});
      machine.inch = inch->flag;
    }
    read_axes(object, machine);
    for (JsonValue const* const item : objects(object, "groups")) machine.groups.push_back(group(*item));
    for (JsonValue const* const item : objects(object, "gantries")) read_gantry(*item, machine);
    machine.programs = texts(object, "programs");
    machine.filter_sets = texts(object, "filter_sets");
    return machine;
  }

 private:
  /// An object whose keys have been checked.
  class Object {
   public:
    Object(MachineFileReader& reader, JsonValue const& value, Words const& known)
        : reader_(reader), value_(value) {
      std::unordered_map<std::string_view, Span> seen;
      for (JsonMember const& member : value.members) {
        if (std::find(known.begin(), known.end(), member.key) == known.end()) {
          reader.unknown_key(member, known);
          continue;
        }
        auto const [first, is_new] = seen.try_emplace(member.key, member.key_span);
        if (is_new) continue;
        Finding& finding = reader.add(member.key_span, Text::ax4020_repeated_key, {{"key", member.key}});
        finding.related.push_back(
            {.place = reader.place(first->second), .message = {.text = Text::ax4020_first, .arguments = {}}});
      }
    }

    [[nodiscard]] JsonValue const* find(std::string_view key) const {
      for (JsonMember const& member : value_.members) {
        if (member.key == key) return &(*reader_.document_)[member.value];
      }
      return nullptr;
    }

    /// The key's value; a finding where it is missing.
    [[nodiscard]] JsonValue const* require(std::string_view key) const {
      JsonValue const* const value = find(key);
      if (value == nullptr) reader_.add(value_.span, Text::ax4020_missing_key, {{"key", std::string(key)}});
      return value;
    }

   private:
    MachineFileReader& reader_;
    JsonValue const& value_;
  };

  [[nodiscard]] Place place(Span span) const { return {.source = source_, .span = span}; }

  Finding& add(Span span, Text text, std::vector<Argument> arguments = {}) {
    return report_.add(place(span), Message{.text = text, .arguments = std::move(arguments)});
  }

  void unknown_key(JsonMember const& member, Words const& known) {
    Finding& finding = add(member.key_span, Text::ax4020_unknown_key, {{"key", member.key}});
    suggest(finding, member.key, known);
    finding.notes.push_back({.text = Text::ax4020_known_keys, .arguments = {{"keys", joined(known)}}});
  }

  static void suggest(Finding& finding, std::string_view written, Words const& known) {
    std::string_view const closest = schema::closest_word(written, known);
    if (closest.empty()) return;
    std::string const word(closest);
    finding.help.push_back({.text = Text::ax4020_did_you_mean, .arguments = {{"suggestion", word}}});
    Fix fix;
    fix.title = {.text = Text::ax4020_fix, .arguments = {{"replacement", word}}};
    fix.edits.push_back({.place = *finding.place, .text = '"' + word + '"'});
    finding.fix = std::move(fix);
  }

  std::optional<LocatedText> as_text(JsonValue const& value, std::string_view key) {
    if (value.kind != JsonKind::string) {
      add(value.span, Text::ax4020_text, {{"key", std::string(key)}});
      return std::nullopt;
    }
    if (value.string.empty()) {
      add(value.span, Text::ax4020_empty_text, {{"key", std::string(key)}});
      return std::nullopt;
    }
    return LocatedText{.text = value.string, .place = place(value.span)};
  }

  std::optional<LocatedText> text(Object const& object, std::string_view key) {
    JsonValue const* const value = object.find(key);
    return value != nullptr ? as_text(*value, key) : std::nullopt;
  }

  std::optional<LocatedText> required_text(Object const& object, std::string_view key) {
    JsonValue const* const value = object.require(key);
    return value != nullptr ? as_text(*value, key) : std::nullopt;
  }

  /// One of a few words, letter case aside; in the spelling of the table.
  std::optional<LocatedText> choice(Object const& object, std::string_view key, Words const& allowed) {
    std::optional<LocatedText> written = text(object, key);
    if (!written) return std::nullopt;
    for (std::string_view const word : allowed) {
      if (ascii::equal_ignoring_case(word, written->text)) {
        written->text = word;
        return written;
      }
    }
    Finding& finding = add(written->place.span, Text::ax4020_one_of,
                           {{"key", std::string(key)}, {"values", joined(allowed)}});
    suggest(finding, written->text, allowed);
    return std::nullopt;
  }

  std::vector<LocatedText> texts_of(JsonValue const& list, std::string_view key) {
    std::vector<LocatedText> result;
    if (list.kind != JsonKind::array) {
      add(list.span, Text::ax4020_list_of_texts, {{"key", std::string(key)}});
      return result;
    }
    for (std::size_t const item : list.items) {
      JsonValue const& value = (*document_)[item];
      if (value.kind != JsonKind::string) {
        add(value.span, Text::ax4020_list_of_texts, {{"key", std::string(key)}});
      } else {
        result.push_back({.text = value.string, .place = place(value.span)});
      }
    }
    return result;
  }

  std::vector<LocatedText> texts(Object const& object, std::string_view key) {
    JsonValue const* const list = object.find(key);
    return list != nullptr ? texts_of(*list, key) : std::vector<LocatedText>{};
  }

  std::vector<JsonValue const*> objects_of(JsonValue const& list, std::string_view key) {
    std::vector<JsonValue const*> result;
    if (list.kind != JsonKind::array) {
      add(list.span, Text::ax4020_list_of_objects, {{"key", std::string(key)}});
      return result;
    }
    for (std::size_t const item : list.items) {
      JsonValue const& value = (*document_)[item];
      if (value.kind == JsonKind::object) {
        result.push_back(&value);
      } else {
        add(value.span, Text::ax4020_list_of_objects, {{"key", std::string(key)}});
      }
    }
    return result;
  }

  std::vector<JsonValue const*> objects(Object const& object, std::string_view key) {
    JsonValue const* const list = object.find(key);
    return list != nullptr ? objects_of(*list, key) : std::vector<JsonValue const*>{};
  }

  std::optional<design::CycleTime> cycle_time(Object const& object) {
    constexpr std::string_view key = "cycle_time_us";
    JsonValue const* const value = object.find(key);
    if (value == nullptr) return std::nullopt;
    if (value->kind != JsonKind::number) {
      add(value->span, Text::ax4020_number, {{"key", std::string(key)}});
      return std::nullopt;
    }
    double const nanoseconds = std::round(value->number * 1e3);
    if (!(nanoseconds >= 1 && nanoseconds <= 1e9)) {
      add(value->span, Text::ax4020_cycle_time, {{"value", format_exact(value->number)}});
      return std::nullopt;
    }
    return design::CycleTime{static_cast<std::uint32_t>(nanoseconds)};
  }

  void read_axes(Object const& object, MachineFile& machine) {
    JsonValue const* const list = object.require("axes");
    if (list == nullptr) return;
    if (list->kind == JsonKind::array && list->items.empty()) add(list->span, Text::ax4020_no_axes);
    for (JsonValue const* const item : objects_of(*list, "axes")) read_axis(*item, machine);
  }

  void read_axis(JsonValue const& value, MachineFile& machine) {
    Object const object(*this, value, words(axis_keys));
    std::optional<LocatedText> name = required_text(object, "name");
    std::optional<LocatedText> list = required_text(object, "list");
    MachineFileAxis axis;
    axis.drive = choice(object, "drive", drive_words());
    axis.position_control = choice(object, "position_control", words(position_controls));
    if (auto const type = choice(object, "type", words(axis_types))) {
      axis.type = type->text == "T"   ? AxisType::translatory
                  : type->text == "R" ? AxisType::rotary
                                      : AxisType::spindle;
    }
    if (name) {
      auto const [first, is_new] = axis_names_.try_emplace(name->text, name->place);
      if (!is_new) {
        Finding& finding = add(name->place.span, Text::ax4020_repeated_axis, {{"name", name->text}});
        finding.related.push_back(
            {.place = first->second, .message = {.text = Text::ax4020_first, .arguments = {}}});
        return;
      }
    }
    if (!name || !list) return;
    axis.name = *std::move(name);
    axis.list = *std::move(list);
    machine.axes.push_back(std::move(axis));
  }

  void require_axes(std::vector<LocatedText>& names) {
    std::vector<std::string_view> known;
    for (auto const& [name, place] : axis_names_) known.push_back(name);
    std::sort(known.begin(), known.end());
    auto const dangling = [&](LocatedText const& name) {
      if (axis_names_.contains(name.text)) return false;
      suggest(add(name.place.span, Text::ax4020_unknown_axis, {{"name", name.text}}), name.text, known);
      return true;
    };
    names.erase(std::remove_if(names.begin(), names.end(), dangling), names.end());
  }

  MachineFileGroup group(JsonValue const& value) {
    Object const object(*this, value, words(group_keys));
    MachineFileGroup group;
    group.name = text(object, "name");
    if (JsonValue const* const axes = object.require("axes")) group.axes = texts_of(*axes, "axes");
    require_axes(group.axes);
    group.programs = texts(object, "programs");
    return group;
  }

  void read_gantry(JsonValue const& value, MachineFile& machine) {
    Object const object(*this, value, words(gantry_keys));
    std::vector<LocatedText> master;
    if (auto name = required_text(object, "master")) master.push_back(*std::move(name));
    std::vector<LocatedText> slaves;
    if (JsonValue const* const list = object.require("slaves")) slaves = texts_of(*list, "slaves");
    require_axes(master);
    require_axes(slaves);
    if (!master.empty()) machine.gantries.push_back({.master = master.front(), .slaves = std::move(slaves)});
  }

  SourceId source_;
  Report report_;
  JsonDocument const* document_ = nullptr;
  std::unordered_map<std::string, Place> axis_names_;
};

}  // namespace

MachineFile read_machine_file(SourceSet const& sources, SourceId source, ReportedFindings& findings) {
  SourceText const& text = sources[source];
  MachineFileReader reader(source, findings);
  auto const parsed = parse_json(text.bytes(), text.text_begin());
  if (auto const* const error = std::get_if<JsonError>(&parsed)) {
    reader.broken(*error);
    return {};
  }
  return reader.read(std::get<JsonDocument>(parsed));
}

bool looks_like_machine_file(std::string_view bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (bytes.substr(0, mark.size()) == mark) bytes.remove_prefix(mark.size());
  std::size_t const first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  return bytes[first] == '{' || bytes.find("\"axes\"") != std::string_view::npos;
}

}  // namespace axisc::validator
