#include "editor/capabilities/hover.hpp"

#include "axisc/answers/explain/explain_answer.hpp"
#include "diagnostics/location.hpp"
#include "editor/meaning/delay_notes.hpp"
#include "editor/meaning/dynamics_notes.hpp"
#include "editor/meaning/filter_figures.hpp"
#include "editor/meaning/parameter_number.hpp"
#include "editor/meaning/program_help.hpp"
#include "editor/reading/open_machines.hpp"
#include "editor/reading/places.hpp"
#include "presentation/writers.hpp"
#include "schema/descriptions/description.hpp"
#include "validator/loading/loader.hpp"
#include "validator/views/units_text.hpp"

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence in_effect{"In effect: {value}, from {file}, line {line}.",
                             "Es gilt: {value}, aus {file}, Zeile {line}."};
constexpr Sentence in_effect_default{"In effect: the default {value}.", "Es gilt: der Standardwert {value}."};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

/// "20000 = 20 ms".
std::string with_unit(std::string_view raw, double number, std::string_view unit, Language language) {
  if (unit.empty()) return std::string(raw);
  auto const physical = validator::physical(number, unit).in(language);
  return std::string(raw) +
         (validator::is_scaled(unit) ? " = " + physical : physical.substr(physical.find(' ')));
}

std::string quantity(OpenList const& list, schema::Parameter const& parameter, std::string_view raw,
                     Language language) {
  auto const number = schema::read_real(raw);
  if (number.status != schema::NumberStatus::good || !parameter.symbols.empty()) return std::string(raw);
  auto text = with_unit(raw, number.number, list.unit_of(parameter), language);
  if (!list.is_unit_open(parameter)) return text;
  return text + " | " + validator::physical(number.number, parameter.unit_rotary).in(language);
}

/// The catalogue's description of an enumeration value; empty if there is none.
std::string value_meaning(schema::Parameter const& parameter, std::string_view raw, Language language) {
  auto const number = schema::read_real(raw);
  bool const is_number = number.status == schema::NumberStatus::good;
  schema::Symbol const* const symbol = is_number ? schema::symbol_of_number(parameter, number.number)
                                                 : schema::read_symbol(parameter, raw).symbol;
  for (auto const& [value, meaning] : schema::description_of(parameter).values) {
    auto const known = schema::read_real(value);
    bool const is_same =
        known.status == schema::NumberStatus::good && is_number && known.number == number.number;
    if (is_same || value == raw || (symbol != nullptr && value == symbol->word)) {
      return std::string(meaning.in(language));
    }
  }
  for (auto const& name : parameter.number_names) {
    if (is_number && name.number && *name.number == number.number) return std::string(name.word);
  }
  return symbol != nullptr && is_number ? std::string(symbol->word) : "";
}

std::string value_text(OpenList const& list, schema::Parameter const& parameter, std::string_view raw,
                       Language language) {
  auto const meaning = value_meaning(parameter, raw, language);
  return quantity(list, parameter, raw, language) + (meaning.empty() ? "" : ": " + meaning);
}

/// The value in effect, if another line or the default decides it.
std::string effective_text(OpenList const& list, schema::Slot slot, std::uint32_t line, Language language) {
  if (list.axis() == nullptr) return {};
  auto const& value = list.axis()->merged.values[slot];
  if (value.unusable || (value.set() && !value.has_value)) return {};
  if (!value.set()) {
    if (!value.row->has_default) return {};
    auto const standard = value_text(list, *value.row, validator::default_text(*value.row), language);
    return "\n" + say(says::in_effect_default, language, {{"value", standard}}) + "\n";
  }
  auto const location = locate(*value.value_place(), list.sources());
  if (value.line == line && location.file == list.text().name()) return {};
  auto const raw = list.sources()[value.source].utf8(value.value_span);
  return "\n" +
         say(says::in_effect, language,
             {{"value", value_text(list, *value.row, raw, language)},
              {"file", std::string(validator::file_name(location.file))},
              {"line", std::to_string(value.line)}}) +
         "\n";
}

}  // namespace

Json hover(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  auto const offset = machines.offset(asked, params);
  auto const language = machines.language();
  bool const markdown = machines.client().markdown;
  auto const answer = [&](std::string text, std::size_t begin, std::size_t end) {
    return Json{{"contents", {{"kind", markdown ? "markdown" : "plaintext"}, {"value", std::move(text)}}},
                {"range", machines.range(asked, begin, end)}};
  };
  auto const format = markdown ? presentation::Format::markdown : presentation::Format::text;
  if (auto const number = parameter_number_at(asked.text, offset)) {
    std::string text;
    auto const catalogue = number->kind == schema::ListKind::axis ? machines.options()(asked.path).catalogue
                                                                  : schema::Catalogue::of(number->kind);
    for (auto const id : catalogue.find_number(number->number)) {
      text += (text.empty() ? "" : "\n") +
              write(parameter_answer(catalogue, catalogue.parameter(id)), format, {.language = language});
    }
    if (!text.empty()) return answer(std::move(text), number->begin, number->end);
  }
  if (asked.path.ends_with(".nc")) {
    auto help = command_help(asked.text, offset, machines.reading_of(asked).machine(), language);
    if (help) return answer(std::move(help->text), help->begin, help->end);
    auto const word = motion_word_at(asked.text, offset);
    if (!word) return nullptr;
    return answer(write(word_answer(*word->word), format, {.language = language}), word->begin, word->end);
  }
  if (!is_list(asked.path)) return nullptr;
  auto const& list = machines.list_of(asked);
  auto const* const line = list.line_at(offset);
  if (line == nullptr) return nullptr;
  auto const name = list.slice(line->name);
  auto const found = list.find(name);
  if (found.row == nullptr) return nullptr;
  if (touches(line->name, offset)) {
    auto text = write(parameter_answer(list.catalogue(), *found.row), format, {.language = language});
    if (found.status == schema::NameLookup::Status::found) {
      text += effective_text(list, found.slot, line->line, language);
      text += DynamicsNotes(list, language).sentence_of(*line, found);
      text += delay_sentences(list, found, language);
      text += filter_figures(list, name, markdown, language);
    }
    return answer(std::move(text), line->name.begin, line->name.end);
  }
  if (!touches(line->value, offset)) return nullptr;
  auto const value = value_text(list, *found.row, list.text().utf8(line->value), language);
  auto const what = schema::description_of(*found.row).what.in(language);
  return answer("`" + std::string(name) + "` " + value + (what.empty() ? "" : "\n\n") + std::string(what) +
                    "\n" + DynamicsNotes(list, language).sentence_of(*line, found) +
                    filter_figures(list, name, markdown, language),
                line->value.begin, line->value.end);
}

}  // namespace axisc::editor
