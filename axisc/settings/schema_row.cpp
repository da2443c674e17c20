#include "axisc/settings/schema_row.hpp"

#include "axisc/settings/sentences.hpp"
#include "configuration/sentences.hpp"
#include "schema/indexed_name.hpp"
#include "validator/loading/build_version.hpp"
#include "validator/values/line_value.hpp"
#include "validator/values/lost_assignment.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::says {

constexpr Sentence name{
    "\"{value}\" is not a parameter name; write it as in a list, in lower case, with [] in place of an "
    "index: filter[].order",
    "\"{value}\" ist kein Parametername; Schreibweise wie in Listen, in Kleinbuchstaben, mit [] an der "
    "Stelle eines Index: filter[].order"};
constexpr Sentence shape{
    "\"{value}\" is known as {known}; a schema file cannot change which of its parts have an index",
    "\"{value}\" ist als {known} bekannt; welche Teile einen Index haben, kann eine Schemadatei nicht "
    "ändern"};
constexpr Sentence type_missing{"{parameter} is new and needs a \"type\"",
                                "{parameter} ist neu und braucht einen \"type\""};
constexpr Sentence identifier{"a number is written P-AXIS-00140",
                              "eine Nummer wird P-AXIS-00140 geschrieben"};
constexpr Sentence array{
    "\"array\" needs {count} whole numbers from 1 to 1000, one for each [] of {parameter}",
    "\"array\" braucht {count} ganze Zahlen von 1 bis 1000, eine je [] von {parameter}"};
constexpr Sentence array_fixed{"{parameter} is compiled into images and keeps its {size} entries",
                               "{parameter} wird in Abbilder kompiliert und behält seine {size} Einträge"};
constexpr Sentence array_smaller{
    "{parameter} has {size} entries; a schema file can only add some",
    "{parameter} hat {size} Einträge; eine Schemadatei kann nur weitere hinzufügen"};
constexpr Sentence limit{
    "a limit is a number, MIN(UNS32), MAX(UNS32) or the number of a parameter, P-AXIS-00140",
    "eine Grenze ist eine Zahl, MIN(UNS32), MAX(UNS32) oder die Nummer eines Parameters, P-AXIS-00140"};
constexpr Sentence limit_type{"limits are for numbers; {parameter} is of type {type}",
                              "Grenzen gelten für Zahlen; {parameter} hat den Typ {type}"};
constexpr Sentence limit_order{"the minimum of {parameter} is above its maximum",
                               "das Minimum von {parameter} liegt über dem Maximum"};
constexpr Sentence symbols{
    "symbols are words of A to Z, 0 to 9 and _ with a number from 0 to 65535 or null",
    "Symbole sind Wörter aus A bis Z, 0 bis 9 und _ mit einer Zahl von 0 bis 65535 oder null"};
constexpr Sentence number_names{"\"number_names\" are words with a number from 0 to 65535",
                                "\"number_names\" sind Wörter mit einer Zahl von 0 bis 65535"};
constexpr Sentence symbols_type{"symbols are for STRING and BOOLEAN; {parameter} is of type {type}",
                                "Symbole gelten für STRING und BOOLEAN; {parameter} hat den Typ {type}"};
constexpr Sentence schema_default{
    R"(the default "{value}" is not a valid value for {parameter}; give it another "default")",
    R"(der Standardwert "{value}" ist kein gültiger Wert für {parameter}; einen anderen ("default") angeben)"};
constexpr Sentence unit{R"(a unit is a text, or an object with "translatory" and "rotary")",
                        R"(eine Einheit ist ein Text oder ein Objekt mit "translatory" und "rotary")"};
constexpr Sentence max_length{"\"max_length\" is a whole number from 1 to 255, for STRING alone",
                              "\"max_length\" ist eine ganze Zahl von 1 bis 255, nur für STRING"};

}  // namespace axisc::says

namespace axisc {

namespace {

using configuration::JsonKey;
using configuration::JsonShape;
using configuration::JsonValue;
using schema::RowContradiction;
using Kind = configuration::JsonShapeKind;
using enum configuration::JsonPresence;

bool is_lower_case_name(std::string_view part) {
  if (part.ends_with("[]")) part.remove_suffix(2);
  auto const is_letter = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
  return !part.empty() && is_letter(part.front()) && std::all_of(part.begin(), part.end(), [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9');
  });
}

/// `getriebe[].dynamik.vb_max`: as in lists, with [] for an index, two of them at most.
bool is_parameter_pattern(std::string_view name) {
  if (std::count(name.begin(), name.end(), '[') > 2) return false;
  while (true) {
    std::size_t const dot = std::min(name.find('.'), name.size());
    if (!is_lower_case_name(name.substr(0, dot))) return false;
    if (dot == name.size()) return true;
    name.remove_prefix(dot + 1);
  }
}

bool is_identifier(std::string_view text) {
  return schema::parse_p_axis(text).has_value();
}

/// MIN(UNS32), MAX(UNS32), P-AXIS-00140.
bool is_limit(std::string_view text) {
  if (is_identifier(text)) return true;
  if (!(text.starts_with("MIN(") || text.starts_with("MAX(")) || !text.ends_with(")")) return false;
  auto const type = schema::parse_data_type(text.substr(4, text.size() - 5));
  return type && schema::is_number(*type);
}

bool is_symbol(std::string_view word) {
  return std::all_of(word.begin(), word.end(),
                     [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; });
}

bool is_build(std::string_view text) {
  return validator::parse_build_version(text).has_value();
}

constexpr JsonShape whole_number(double lowest, double highest, std::optional<SentenceRef> sentence = {}) {
  return {.kind = Kind::whole_number, .lowest = lowest, .highest = highest, .sentence = sentence};
}

template <std::size_t count>
constexpr JsonShape either(std::array<JsonShape const*, count> const& shapes, SentenceRef sentence) {
  return {.kind = Kind::either, .alternatives = shapes, .sentence = sentence};
}

constexpr JsonShape identifier_shape{
    .accepts = is_identifier, .pattern = "^P-AXIS-[0-9]{5}$", .sentence = says::identifier};
constexpr JsonShape name_shape{
    .accepts = is_parameter_pattern,
    .pattern = R"(^(?!(.*\[){3})[a-z_][a-z0-9_]*(\[\])?(\.[a-z_][a-z0-9_]*(\[\])?)*$)",
    .sentence = says::name};
constexpr JsonShape type_shape{.words = schema::data_type_words};
constexpr JsonShape array_size_shape = whole_number(1, 1000);
constexpr JsonShape array_shape{.kind = Kind::list, .items = &array_size_shape, .fewest = 1};
constexpr JsonShape default_text_shape{.may_be_empty = true};

constexpr std::array unit_keys = {
    JsonKey{"translatory", &configuration::json_text, required, "Of linear axes."},
    JsonKey{"rotary", &configuration::json_text, required, "Of rotary axes and spindles."}};
constexpr JsonShape units_shape{.kind = Kind::object, .title = "Unit per kind of axis", .keys = unit_keys};
constexpr std::array unit_shapes = {&configuration::json_text, &units_shape};
constexpr JsonShape unit_shape = either(unit_shapes, says::unit);

constexpr JsonShape any_number_shape{.kind = Kind::number};
constexpr JsonShape limit_text_shape{
    .accepts = is_limit,
    .pattern = "^((MIN|MAX)\\((UNS08|UNS16|UNS32|UNS64|SGN08|SGN16|SGN32|SGN64|REAL64)\\)|P-AXIS-[0-9]{5})$"};
constexpr std::array limit_shapes = {&any_number_shape, &limit_text_shape};
constexpr JsonShape limit_shape = either(limit_shapes, says::limit);

constexpr JsonShape symbol_shape{.accepts = is_symbol, .pattern = "^[A-Z0-9_]+$", .sentence = says::symbols};
constexpr JsonShape number_of_word_shape = whole_number(0, 65535, says::number_names);
constexpr std::array symbol_number_shapes = {&number_of_word_shape, &configuration::json_null};
constexpr JsonShape symbol_number_shape = either(symbol_number_shapes, says::symbols);
constexpr JsonShape symbols_shape{.kind = Kind::map,
                                  .items = &symbol_number_shape,
                                  .names = &symbol_shape,
                                  .fewest = 1,
                                  .sentence = says::symbols};
constexpr JsonShape number_names_shape{
    .kind = Kind::map, .items = &number_of_word_shape, .names = &configuration::json_text};

constexpr JsonShape max_length_shape = whole_number(1, 255);
constexpr std::array<std::string_view, 3> axis_type_words = {"T", "R", "S"};
constexpr JsonShape axis_type_shape{.words = axis_type_words};
constexpr JsonShape axis_types_shape{
    .kind = Kind::list, .items = &axis_type_shape, .fewest = 1, .distinct = true};
constexpr JsonShape since_shape{.accepts = is_build,
                                .pattern = R"(^[Vv]?[0-9]+\.[0-9]+\.[0-9]+(\.[0-9]+)?$)",
                                .sentence = says::settings_build};

constexpr std::array row_keys = {
    JsonKey{"id", &identifier_shape, optional, "Documented number; several names may share one."},
    JsonKey{"name", &name_shape, required, "As lists write it, with [] for each index, two at most."},
    JsonKey{"type", &type_shape, optional, "Needed for a name that is not known yet."},
    JsonKey{"array", &array_shape, optional,
            "Number of entries per index, in the order of the [] in the name."},
    JsonKey{"default", &default_text_shape, optional,
            "A number, a word, a text (may be empty), or P-AXIS-nnnnn for the value of that parameter."},
    JsonKey{"unit", &unit_shape, optional,
            "Unit of the raw number: one for all axes, or one per kind of axis."},
    JsonKey{"minimum", &limit_shape, optional, "A number, a limit of a data type, or another parameter."},
    JsonKey{"exclusive_minimum", &limit_shape, optional, "A minimum that is not allowed itself.", nullptr,
            "minimum"},
    JsonKey{"maximum", &limit_shape, optional, "A number, a limit of a data type, or another parameter."},
    JsonKey{"exclusive_maximum", &limit_shape, optional, "A maximum that is not allowed itself.", nullptr,
            "maximum"},
    JsonKey{"symbols", &symbols_shape, optional,
            "Words of an enumeration with their numbers, null where none is documented. A boolean always "
            "knows FALSE and TRUE; its symbols are further words for 0 and 1."},
    JsonKey{"flags", &configuration::json_flag, optional,
            "The numbers of the words are bits: a list joins several words by `|`, or writes the sum."},
    JsonKey{"number_names", &number_names_shape, optional,
            "What single numbers mean, in words for people; lists cannot write them."},
    JsonKey{"max_length", &max_length_shape, optional, "Of a string, in characters."},
    JsonKey{"axis_types", &axis_types_shape, optional,
            "Kinds of axis (translatory, rotary, spindle) that know the parameter; left out: all."},
    JsonKey{"former_name", &configuration::json_text, optional,
            "What the control called it in earlier versions, without []."},
    JsonKey{"since", &since_shape, optional, "Build of the control that introduced the parameter."}};

}  // namespace

constexpr JsonShape schema_row_shape{.kind = Kind::object, .title = "Parameter", .keys = row_keys};

namespace {

std::string sizes_text(schema::ArraySizes const& sizes) {
  return sizes[1] == 0 ? std::to_string(sizes[0])
                       : std::to_string(sizes[0]) + " x " + std::to_string(sizes[1]);
}

/// In the order of RowContradiction.
constexpr std::array<SentenceRef, 8> sentences = {
    says::type_missing, says::array,         says::limit_type,
    says::limit_order,  says::symbols_type,  axisc::configuration::says::json_repeated_value,
    says::max_length,   says::schema_default};

class EntryReader {
 public:
  EntryReader(LocatedFile const& file, JsonValue const& entry, schema::Catalogue const& catalogue)
      : file_(file), entry_(entry), catalogue_(catalogue) {}

  schema::RowReading read(nlohmann::ordered_json const& json) {
    schema::Parameter const* const known = find_known(file_.find(entry_, "name")->string);
    schema::RowReading reading = schema::read_row(json, known);
    reading.row.file = file_.path();
    if (!reading.problems.empty()) refuse(reading.row, reading.problems.front());
    if (known != nullptr) require_room(*known, reading.row);
    return reading;
  }

 private:
  /// Position of a key's value; of the name if the entry does not have the key.
  [[nodiscard]] Span span_of(std::string_view key) const {
    auto const* const value = file_.find(entry_, key);
    return value == nullptr ? file_.find(entry_, "name")->span : value->span;
  }

  [[nodiscard]] schema::Parameter const* find_known(std::string const& wanted) const {
    for (auto const& known : catalogue_.parameters()) {
      if (known.name == wanted) return &known;
    }
    // A name is known with one set of indices, and lists may spell it with any of them.
    for (auto const& known : catalogue_.parameters()) {
      if (schema::without_brackets(known.name) != schema::without_brackets(wanted)) continue;
      file_.refuse(span_of("name"), says::shape, {{"value", wanted}, {"known", std::string(known.name)}});
    }
    return nullptr;
  }

  [[noreturn]] void refuse(schema::ParameterRow const& row, schema::RowProblem const& problem) const {
    auto const indices = std::count(row.name.begin(), row.name.end(), '[');
    bool const at_key = problem.what == RowContradiction::limits_of_words;
    Span const span = at_key ? entry_.find(problem.key)->key_span : span_of(problem.key);
    file_.refuse(span, sentences.at(static_cast<std::size_t>(problem.what)),
                 {{"key", std::string(problem.key)},
                  {"parameter", row.name},
                  {"type", std::string(schema::data_type_name(row.type))},
                  {"count", std::to_string(indices)},
                  {"value", problem.value}});
  }

  /// Known arrays can grow, unless images contain their entries.
  void require_room(schema::Parameter const& known, schema::ParameterRow const& row) const {
    if (known.array == row.array) return;
    std::vector<Argument> const arguments{{"parameter", row.name}, {"size", sizes_text(known.array)}};
    if (validator::is_compiled_family(row.name)) {
      file_.refuse(span_of("array"), says::array_fixed, arguments);
    }
    if (row.array[0] < known.array[0] || row.array[1] < known.array[1]) {
      file_.refuse(span_of("array"), says::array_smaller, arguments);
    }
  }

  LocatedFile const& file_;
  JsonValue const& entry_;
  schema::Catalogue const& catalogue_;
};

}  // namespace

schema::RowReading read_schema_entry(LocatedFile const& file, JsonValue const& entry,
                                     nlohmann::ordered_json const& json, schema::Catalogue const& catalogue) {
  return EntryReader(file, entry, catalogue).read(json);
}

}  // namespace axisc
