#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/explain/parameter_ranges.hpp"
#include "axisc/answers/labels.hpp"
#include "schema/descriptions/description.hpp"
#include "schema/value.hpp"
#include "validator/views/units_text.hpp"

namespace axisc::says {

constexpr Sentence numbered{"{name} ({number})", "{name} ({number})"};
constexpr Sentence sentence{"{phrase}.", "{phrase}."};
constexpr Sentence inferred{
    "{phrase} (told by the family of its name; the manuals do not describe this parameter).",
    "{phrase} (aus der Familie des Namens; die Handbücher beschreiben diesen Parameter nicht)."};
constexpr Sentence list{"kind of list", "Art der Liste"};
constexpr Sentence types{"types", "Typen"};
constexpr Sentence range{"range", "Wertebereich"};
constexpr Sentence or_default{"{range}, or {default}", "{range} oder {default}"};
constexpr Sentence symbols{"symbols", "Symbole"};
constexpr Sentence standard{"default", "Standardwert"};
constexpr Sentence unit{"unit of the number", "Einheit der Zahl"};
constexpr Sentence units{"{translatory} (translatory), {rotary} (rotary)",
                         "{translatory} (translatorisch), {rotary} (rotatorisch)"};
constexpr Sentence restart{"changes take effect", "Änderungen wirken"};
constexpr Sentence after_restart{"after a restart of the control", "nach einem Neustart der Steuerung"};
constexpr Sentence array{"entries", "Einträge"};
constexpr Sentence entries{"`{first}` to `{last}`", "`{first}` bis `{last}`"};
constexpr Sentence longest{"longest text, in characters", "längster Text, in Zeichen"};
constexpr Sentence axis_types{"axis types", "Achstypen"};
constexpr Sentence since_build{"since build", "ab Version"};
constexpr Sentence manual{"manual", "Handbuch"};
constexpr Sentence rules_about_it{"rules that check it", "Regeln, die ihn prüfen"};
constexpr Sentence example{"In a list, with its default:", "In einer Liste, mit dem Standardwert:"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

Value text_or_nothing(Wording text) {
  return text.empty() ? Value() : Value(std::move(text));
}

Value limit_value(schema::ListKind kind, schema::Limit const& limit) {
  if (limit.kind == schema::Limit::Kind::none) return {};
  if (limit.kind == schema::Limit::Kind::number) return exact(limit.number);
  return schema::number_text(kind, limit.p_axis);
}

/// Null without a limit.
Block limit_object(std::string key, schema::ListKind kind, schema::Limit const& limit) {
  auto value = limit_value(kind, limit);
  if (value.is_nothing()) return Facts{{data(std::move(key), std::move(value))}};
  auto const* const name = value.is_number() ? "number" : "p_axis";
  return data_section(std::move(key), {data(name, std::move(value)), data("open", limit.open)});
}

Value range_of(schema::Parameter const& parameter) {
  auto lowest = limit_value(parameter.kind, parameter.minimum);
  auto highest = limit_value(parameter.kind, parameter.maximum);
  if (parameter.is_enumeration() || (lowest.is_nothing() && highest.is_nothing())) return {};
  auto range =
      range_words(std::move(lowest), parameter.minimum.open, std::move(highest), parameter.maximum.open);
  // The control takes the default even where it is outside.
  auto const standard = schema::default_value(parameter);
  if (!standard || !standard->text.empty() || !schema::is_outside(parameter, standard->number)) return range;
  return Words(says::or_default, {{"range", range}, {"default", exact(standard->number)}});
}

/// "200000 (200 mm/s)".
Value default_in_units(schema::Parameter const& parameter) {
  if (!parameter.has_default) return {};
  auto const value = schema::default_value(parameter);
  auto const text = validator::default_text(parameter);
  auto const shown = value && value->text.empty() ? Wording::number(text) : Wording(text);
  if (!value || value->number == 0 || !validator::is_scaled(parameter.unit_translatory)) return shown;
  return shown + " (" + validator::physical(value->number, parameter.unit_translatory) + ")";
}

Value unit_of(schema::Parameter const& parameter) {
  auto const linear = validator::unit_name(parameter.unit_translatory);
  auto const rotary = validator::unit_name(parameter.unit_rotary);
  if (rotary.empty() || linear.written() == rotary.written()) return text_or_nothing(linear);
  return Words(says::units, {{"translatory", linear}, {"rotary", rotary}});
}

/// `filter[2].order` of the last entry, so that the number of entries is seen at once.
Value entries_of(schema::Parameter const& parameter) {
  if (parameter.index_count() == 0) return {};
  auto const last =
      static_cast<schema::Slot>(static_cast<unsigned>(parameter.first_slot) + parameter.slots - 1U);
  return Words(says::entries, {{"first", schema::slot_name(parameter, parameter.first_slot)},
                               {"last", schema::slot_name(parameter, last)}});
}

std::string symbols_of(std::span<schema::Symbol const> symbols) {
  std::string text;
  for (auto const& [word, number] : symbols) {
    text += (text.empty() ? "" : ", ") + std::string(word);
    if (number) text += " (" + std::to_string(*number) + ")";
  }
  return text;
}

Table symbols_table(std::string key, std::span<schema::Symbol const> symbols) {
  Table table{.key = std::move(key)};
  for (auto const& [word, number] : symbols) {
    add_row(table, {data("word", word), data("number", number ? Value(*number) : Value())});
  }
  return table;
}

Names rules_about(schema::Parameter const& parameter) {
  Names codes;
  for (auto const& rule : validator::rules()) {
    if (parameter.kind == schema::ListKind::axis && validator::looks_at(rule, parameter)) {
      codes.push_back(code_text(rule.code));
    }
  }
  return codes;
}

Facts facts_of(schema::Catalogue const& catalogue, schema::Parameter const& parameter, bool needs_restart) {
  auto const list = schema::row_of(parameter.kind).word;
  auto const types = parameter.axis_types;
  Names letters;
  for (char const letter : types) letters.emplace_back(1, letter);
  Numbers sizes;
  for (std::size_t i = 0; i < parameter.index_count(); ++i) sizes.values.push_back(parameter.array[i]);
  auto const default_text = validator::default_text(parameter);
  auto const max_length = parameter.max_length > 0 ? Value(parameter.max_length) : Value();
  return {{data("list", list),
           shown(says::list, parameter.kind == schema::ListKind::axis ? "" : list),
           {"type", labels::type, schema::data_type_name(parameter.type)},
           shown(says::range, range_of(parameter)),
           shown(says::symbols, symbols_of(parameter.symbols)),
           data("default", parameter.has_default ? Value(default_text) : Value()),
           shown(says::standard, default_in_units(parameter)),
           shown(says::unit, unit_of(parameter)),
           data("restart", needs_restart),
           shown(says::restart, needs_restart ? Value(Words(says::after_restart)) : Value()),
           data("entries", std::move(sizes)),
           shown(says::array, entries_of(parameter)),
           {"max_length", says::longest, max_length},
           data("axis_types", types.empty() ? "TRS" : types),
           shown(says::axis_types, std::move(letters)),
           {"since", says::since_build, text_or_nothing(parameter.since)},
           {"file", labels::from, text_or_nothing(catalogue.file_of(parameter))},
           {"manual", says::manual, text_or_nothing(Wording(schema::manual_section(parameter)))},
           {"rules", says::rules_about_it, rules_about(parameter)}}};
}

}  // namespace

Section parameter_section(schema::Catalogue const& catalogue, schema::Parameter const& parameter) {
  auto const& [what, detail, meanings, is_inferred, needs_restart] = schema::description_of(parameter);
  auto const number = schema::number_text(parameter.kind, parameter.p_axis);
  Table values{.key = "values"};
  for (auto const& [value, meaning] : meanings) {
    add_row(values, {{"value", labels::value, value}, {"meaning", labels::meaning, Wording(meaning)}});
  }
  Table ranges{.key = "ranges_by_type"};
  for (auto const& [types, range] : ranges_by_type(parameter)) {
    add_row(ranges, {{"types", says::types, types}, {"range", says::range, range}});
  }
  Section section{
      .key = {},
      .title = number.empty() ? as_given(parameter.name)
                              : Words(says::numbered, {{"name", parameter.name}, {"number", number}}),
      .blocks = {},
      .identity = {data("name", parameter.name), data("p_axis", text_or_nothing(number)),
                   data("meaning", text_or_nothing(Wording(what))),
                   data("detail", text_or_nothing(Wording(detail))), data("inferred", is_inferred)}};
  auto& blocks = section.blocks;
  if (!what.english.empty()) {
    blocks.emplace_back(
        Paragraph{Words(is_inferred ? says::inferred : says::sentence, {{"phrase", Wording(what)}})});
  }
  if (!detail.english.empty()) blocks.emplace_back(Paragraph{as_given(Wording(detail))});
  std::vector<Block> const more{
      facts_of(catalogue, parameter, needs_restart),
      limit_object("minimum", parameter.kind, parameter.minimum),
      limit_object("maximum", parameter.kind, parameter.maximum),
      data_section("unit", {data("translatory", text_or_nothing(parameter.unit_translatory)),
                            data("rotary", text_or_nothing(parameter.unit_rotary))}),
      symbols_table("symbols", parameter.symbols),
      symbols_table("number_names", parameter.number_names),
      std::move(values),
      std::move(ranges)};
  blocks.insert(blocks.end(), more.begin(), more.end());
  if (parameter.default_text.empty()) return section;
  blocks.emplace_back(Paragraph{says::example});
  blocks.emplace_back(Verbatim{
      .key = {},
      .text = schema::slot_name(parameter, parameter.first_slot) + "  " + validator::default_text(parameter),
      .audience = Audience::people});
  return section;
}

}  // namespace axisc
