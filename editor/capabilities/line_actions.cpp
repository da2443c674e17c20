#include "editor/capabilities/line_actions.hpp"

#include "editor/reading/places.hpp"
#include "schema/value.hpp"
#include "validator/views/units_text.hpp"
#include "validator/views/written_unit.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence allow{"Allow {code} on this line", "{code} in dieser Zeile zulassen"};
constexpr Sentence explain{"Explain {code}", "{code} erklären"};
constexpr Sentence convert{"Convert {written} to {number}, in {unit}",
                           "{written} in {number} umrechnen, in {unit}"};
constexpr Sentence name_value{"Write \"{word}\" as a comment", "\"{word}\" als Kommentar dazuschreiben"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

constexpr std::string_view directive = "axisc: allow ";

/// The text that makes the comment of a line allow a code.
std::string allowance(std::string_view comment, std::string const& code) {
  if (comment.empty()) return "  ( " + std::string(directive) + code;
  auto const before = comment.rfind(directive);
  bool const continues = before != std::string_view::npos &&
                         comment.find_first_of(" \t", before + directive.size()) == std::string_view::npos;
  return continues ? "," + code : " " + std::string(directive) + code;
}

std::size_t end_of(grammar::Assignment const& line) {
  return std::max(line.value.end, line.trailer.end);
}

bool is_comment(grammar::TrailerKind kind) {
  using grammar::TrailerKind;
  return kind == TrailerKind::parenthesis || kind == TrailerKind::hash;
}

/// A value with a unit after it: "20 ms", "42.5Hz", "0,1 kHz".
struct Measured {
  std::string text;  ///< as it is written
  double number = 0;
  std::string unit;
};

std::optional<Measured> measured(OpenList const& list, grammar::Assignment const& line) {
  bool const has_text = line.trailer_kind == grammar::TrailerKind::text;
  auto text =
      list.text().utf8({.begin = line.value.begin, .end = has_text ? line.trailer.end : line.value.end});
  auto const size = std::min(text.find_first_not_of("+-.,0123456789"), text.size());
  auto digits = text.substr(0, size);
  std::replace(digits.begin(), digits.end(), ',', '.');
  auto const number = schema::read_real(digits);
  auto const begin = text.find_first_not_of(" \t", size);
  if (number.status != schema::NumberStatus::good || begin == std::string::npos) return std::nullopt;
  auto const end = std::min(text.find_first_of(" \t(", begin), text.size());
  auto unit = text.substr(begin, end - begin);
  if (!validator::is_unit(unit)) return std::nullopt;
  text.resize(end);
  return Measured{.text = std::move(text), .number = number.number, .unit = std::move(unit)};
}

}  // namespace

Json LineActions::insertion(TextPosition at, std::string const& text) const {
  return {{"changes", {{document_.uri, Json::array({{{"range", range_json(at, at)}, {"newText", text}}})}}}};
}

void LineActions::add_rewrite(std::string title, std::size_t at, std::string const& text) {
  actions_.push_back({{"title", std::move(title)},
                      {"kind", "refactor.rewrite"},
                      {"edit", insertion(position_of(document_.text, at, machines_.encoding()), text)}});
}

void LineActions::add_allowance(Finding const& finding, Json const& shown) {
  std::string const code = code_text(finding.code);
  auto const add = [&](SentenceRef title, std::string const& what, Json does) {
    actions_.push_back({{"title", machines_.say(title, {{"code", code}})},
                        {"kind", "quickfix"},
                        {"diagnostics", Json::array({shown})},
                        {what, std::move(does)}});
  };
  if (is_list(document_.path)) {
    auto const& list = machines_.list_of(document_);
    TextLines const lines(document_.text, machines_.encoding());
    auto const line = shown["range"]["start"]["line"].get<std::size_t>();
    auto const* const assignment = line < lines.count() ? list.line_at(lines.begin(line)) : nullptr;
    // A line that cannot be read as name and value has its allowance above.
    auto const comment = assignment == nullptr ? std::string_view() : list.slice(assignment->trailer);
    bool const is_beside = assignment != nullptr && (comment.empty() || is_comment(assignment->trailer_kind));
    auto const at = is_beside ? lines.position(end_of(*assignment)) : TextPosition{.line = line};
    auto const text = is_beside ? allowance(comment, code) : "( " + std::string(directive) + code + "\n";
    add(says::allow, "edit", insertion(at, text));
  }
  add(says::explain, "command",
      {{"title", machines_.say(says::explain, {{"code", code}})},
       {"command", "axisc.explain"},
       {"arguments", {document_.uri, code}}});
}

void LineActions::add_conversion(std::size_t offset) {
  if (!is_list(document_.path)) return;
  auto const& list = machines_.list_of(document_);
  auto const* const line = list.line_at(offset);
  if (line == nullptr) return;
  auto const found = list.find(list.slice(line->name));
  auto const value = measured(list, *line);
  if (found.row == nullptr || !value || !schema::is_number(found.row->type)) return;
  // A list alone may be one for axes of both types.
  for (auto const unit : {found.row->unit_translatory, found.row->unit_rotary}) {
    auto const ratio = validator::unit_ratio(value->unit, unit);
    if (!ratio) continue;
    bool const is_right =
        *ratio == 1 && schema::read_real(list.slice(line->value)).status == schema::NumberStatus::good;
    auto const number =
        validator::converted_number(value->number, *ratio, schema::is_integer(found.row->type));
    if (is_right || number.empty()) return;
    auto title = machines_.say(
        says::convert,
        {{"written", value->text}, {"number", number}, {"unit", validator::raw_unit_name(unit)}});
    return add_rewrite(std::move(title), line->value.begin, number + " ( ");
  }
}

void LineActions::add_word(std::size_t offset) {
  if (!is_list(document_.path)) return;
  auto const& list = machines_.list_of(document_);
  auto const* const line = list.line_at(offset);
  if (line == nullptr || !list.slice(line->trailer).empty()) return;
  auto const found = list.find(list.slice(line->name));
  auto const number = schema::read_real(list.slice(line->value));
  if (found.row == nullptr || number.status != schema::NumberStatus::good) return;
  auto const* const symbol = schema::symbol_of_number(*found.row, number.number);
  if (symbol == nullptr) return;
  std::string const word(symbol->word);
  add_rewrite(machines_.say(says::name_value, {{"word", word}}), line->value.end, "  ( " + word);
}

}  // namespace axisc::editor
