#include "axisc/answers/explain/explain_formats.hpp"
#include "axisc/answers/explain/parameter_facts.hpp"
#include "diagnostics/format_number.hpp"
#include "schema/descriptions/description.hpp"
#include "schema/value.hpp"
#include "validator/views/units_text.hpp"

#include <utility>

namespace axisc::says {

constexpr Sentence manual{"manual", "Handbuch"};
constexpr Sentence list{"kind of list", "Art der Liste"};
constexpr Sentence type{"type", "Typ"};
constexpr Sentence range{"range", "Wertebereich"};
constexpr Sentence range_by_type{"range by type", "Wertebereich je Typ"};
constexpr Sentence or_default{"{range}, or {default}", "{range} oder {default}"};
constexpr Sentence values{"values", "Werte"};
constexpr Sentence inferred{
    "{what} (told by the family of its name; the manuals do not describe this parameter)",
    "{what} (aus der Familie des Namens; die Handbücher beschreiben diesen Parameter nicht)"};
constexpr Sentence value{"value", "Wert"};
constexpr Sentence symbols{"symbols", "Symbole"};
constexpr Sentence explain_default{"default", "Standardwert"};
constexpr Sentence unit{"unit of the number", "Einheit der Zahl"};
constexpr Sentence units{"{translatory} (translatory), {rotary} (rotary)",
                         "{translatory} (translatorisch), {rotary} (rotatorisch)"};
constexpr Sentence restart{"changes take effect", "Änderungen wirken"};
constexpr Sentence after_restart{"after a restart of the control", "nach einem Neustart der Steuerung"};
constexpr Sentence array{"entries", "Einträge"};
constexpr Sentence entries{"`{first}` to `{last}`", "`{first}` bis `{last}`"};
constexpr Sentence longest{"longest text, in characters", "längster Text, in Zeichen"};
constexpr Sentence axis_types{"axis types", "Achstypen"};
constexpr Sentence since{"since build", "ab Version"};
constexpr Sentence rules{"rules that check it", "Regeln, die ihn prüfen"};
constexpr Sentence example{"In a list, with its default:", "In einer Liste, mit dem Standardwert:"};

constexpr Sentence file{"from", "aus"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string say(SentenceRef text, Language language, std::vector<Argument> arguments = {}) {
  return render({.sentence = text, .arguments = std::move(arguments)}, language);
}

/// "0 ≤", "< P-AXIS-00008": empty where there is no limit.
Wording limit_text(schema::ListKind kind, schema::Limit const& limit) {
  switch (limit.kind) {
    case schema::Limit::Kind::none:
      return {};
    case schema::Limit::Kind::number:
      return exact_number(limit.number);
    case schema::Limit::Kind::parameter:
      return schema::number_text(kind, limit.p_axis);
  }
  return {};
}

std::string range_text(schema::Parameter const& parameter, Language language) {
  auto const minimum = limit_text(parameter.kind, parameter.minimum).in(language);
  auto const maximum = limit_text(parameter.kind, parameter.maximum).in(language);
  if (minimum.empty() && maximum.empty()) return {};
  std::string text = say(says::value, language);
  if (!minimum.empty()) text = minimum + (parameter.minimum.open ? " < " : " ≤ ") + text;
  if (!maximum.empty()) text += (parameter.maximum.open ? " < " : " ≤ ") + maximum;
  // The control takes the default even where it is outside.
  auto const standard = schema::default_value(parameter);
  if (!standard || !standard->text.empty() || !schema::is_outside(parameter, standard->number)) return text;
  return say(says::or_default, language, {{"range", text}, {"default", exact_number(standard->number)}});
}

std::string meaning(schema::Description const& description, Language language) {
  std::string what(description.what.in(language));
  if (what.empty()) return {};
  if (description.inferred) what = say(says::inferred, language, {{"what", std::move(what)}});
  what += ".";
  auto const detail = description.detail.in(language);
  return what + "\n" + (detail.empty() ? "" : "\n" + std::string(detail) + "\n") + "\n";
}

std::string values_text(schema::Description const& description, Language language) {
  std::string text;
  for (auto const& [value, meaning] : description.values) {
    text += "\n  - `" + std::string(value) + "`: " + std::string(meaning.in(language));
  }
  return text;
}

std::string symbols_text(schema::Parameter const& parameter) {
  std::string text;
  for (auto const& symbol : parameter.symbols) {
    text += (text.empty() ? "`" : ", `") + std::string(symbol.word) + "`";
    if (symbol.number) text += " (" + std::to_string(*symbol.number) + ")";
  }
  return text;
}

std::string unit_text(schema::Parameter const& parameter, Language language) {
  auto linear = unit_name(parameter.unit_translatory, language);
  auto rotary = unit_name(parameter.unit_rotary, language);
  if (linear == rotary || rotary.empty()) return linear;
  return say(says::units, language, {{"translatory", std::move(linear)}, {"rotary", std::move(rotary)}});
}

/// `filter[2].order` of the last entry, so that the number of entries is seen at once.
std::string entries_text(schema::Parameter const& parameter, Language language) {
  if (parameter.index_count() == 0) return {};
  auto const last =
      static_cast<schema::Slot>(static_cast<unsigned>(parameter.first_slot) + parameter.slots - 1U);
  return say(says::entries, language,
             {{"first", schema::slot_name(parameter, parameter.first_slot)},
              {"last", schema::slot_name(parameter, last)}});
}

/// "200000 (200 mm/s)".
std::string default_in_units(schema::Parameter const& parameter, Language language) {
  auto const value = schema::default_value(parameter);
  bool const is_number = value && value->text.empty();
  auto text = (is_number ? Wording::number(default_text(parameter)) : default_text(parameter)).in(language);
  if (!value || value->number == 0 || !validator::is_scaled(parameter.unit_translatory)) return text;
  return text + " (" + validator::physical(value->number, parameter.unit_translatory).in(language) + ")";
}

std::string joined(std::vector<std::string> const& words) {
  std::string text;
  for (auto const& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string axis_types_text(std::string_view letters) {
  std::vector<std::string> words;
  for (char const letter : letters) words.emplace_back(1, letter);
  return joined(words);
}

std::string example(schema::Parameter const& parameter) {
  if (parameter.default_text.empty()) return {};
  return "    " + schema::slot_name(parameter, parameter.first_slot) + "  " + default_text(parameter) + "\n";
}

}  // namespace

std::string explain_parameter(schema::Catalogue const& catalogue, schema::Parameter const& parameter,
                              Language language) {
  std::string text = "# " + std::string(parameter.name);
  if (parameter.p_axis != 0) text += " (" + schema::number_text(parameter.kind, parameter.p_axis) + ")";
  text += "\n\n";
  auto const description = schema::description_of(parameter);
  text += meaning(description, language);
  auto const row = [&](SentenceRef label, std::string const& value) {
    if (value.empty()) return;
    text += "- " + say(label, language) + (value.starts_with('\n') ? ":" : ": ") + value + "\n";
  };
  bool const is_of_axes = parameter.kind == schema::ListKind::axis;
  row(says::list, is_of_axes ? "" : std::string(schema::row_of(parameter.kind).word));
  row(says::type, std::string(schema::data_type_name(parameter.type)));
  row(says::range, parameter.is_enumeration() ? "" : range_text(parameter, language));
  for (auto const& range : ranges_by_type(parameter, language)) row(says::range_by_type, range);
  row(says::symbols, symbols_text(parameter));
  row(says::values, values_text(description, language));
  row(says::explain_default, parameter.has_default ? default_in_units(parameter, language) : "");
  row(says::unit, unit_text(parameter, language));
  row(says::restart, description.restart ? say(says::after_restart, language) : "");
  row(says::array, entries_text(parameter, language));
  row(says::longest, parameter.max_length == 0 ? "" : std::to_string(parameter.max_length));
  row(says::axis_types, axis_types_text(parameter.axis_types));
  row(says::since, std::string(parameter.since));
  row(says::file, std::string(catalogue.file_of(parameter)));
  row(says::manual, manual_section(parameter, language));
  row(says::rules, joined(rules_about(parameter)));
  if (auto const line = example(parameter); !line.empty()) {
    text += "\n" + say(says::example, language) + "\n\n" + line;
  }
  return text;
}

std::string list_parameters(std::span<schema::Parameter const* const> parameters, Language language) {
  std::string text;
  for (auto const* const parameter : parameters) {
    text += "- `" + std::string(parameter->name) + "`";
    if (parameter->p_axis != 0) {
      text += " (" + schema::number_text(parameter->kind, parameter->p_axis) + ")";
    }
    auto const what = schema::description_of(*parameter).what.in(language);
    text += (what.empty() ? "" : ": " + std::string(what)) + "\n";
  }
  return text;
}

}  // namespace axisc
