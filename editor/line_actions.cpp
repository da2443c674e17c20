#include "diagnostics/location.hpp"
#include "editor/reading/open_list.hpp"
#include "editor/reading/places.hpp"
#include "editor/server.hpp"
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

using Json = nlohmann::json;

constexpr std::string_view directive = "axisc: allow ";

/// What makes the line's comment allow a code.
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

}  // namespace

void Server::add_finding_actions(Json& actions, Finding const& finding, Json const& shown,
                                 Document const& document) {
  std::string const code = code_text(finding.code);
  auto const say = [&](SentenceRef sentence) {
    return render({.sentence = sentence, .arguments = {{"code", code}}}, surroundings_.language);
  };
  if (is_list(document.path)) {
    auto const& list = list_of(document);
    TextLines const lines(document.text, encoding_);
    auto const line = shown["range"]["start"]["line"].get<std::size_t>();
    auto const* const assignment = line < lines.count() ? list.line_at(lines.begin(line)) : nullptr;
    // A line that cannot be read as name and value has its allowance above.
    auto const comment = assignment == nullptr ? std::string_view() : list.slice(assignment->trailer);
    bool const is_beside = assignment != nullptr && (comment.empty() || is_comment(assignment->trailer_kind));
    auto const at = is_beside ? lines.position(end_of(*assignment)) : TextPosition{.line = line};
    auto const text = is_beside ? allowance(comment, code) : "( " + std::string(directive) + code + "\n";
    Json const edit = {{"range", range_json(at, at)}, {"newText", text}};
    actions.push_back({{"title", say(says::allow)},
                       {"kind", "quickfix"},
                       {"diagnostics", Json::array({shown})},
                       {"edit", {{"changes", {{document.uri, Json::array({edit})}}}}}});
  }
  actions.push_back(
      {{"title", say(says::explain)},
       {"kind", "quickfix"},
       {"diagnostics", Json::array({shown})},
       {"command",
        {{"title", say(says::explain)}, {"command", "axisc.explain"}, {"arguments", {document.uri, code}}}}});
}

namespace {

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

/// The number that the control reads for a value that was written with its unit, which stays as a comment.
void Server::add_unit_action(Json& actions, Document const& document, std::size_t offset) {
  if (!is_list(document.path)) return;
  auto const& list = list_of(document);
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
    auto const at = position_of(document.text, line->value.begin, encoding_);
    Json const edit = {{"range", range_json(at, at)}, {"newText", number + " ( "}};
    actions.push_back({{"title", render({.sentence = says::convert,
                                         .arguments = {{"written", value->text},
                                                       {"number", number},
                                                       {"unit", validator::raw_unit_name(unit)}}},
                                        surroundings_.language)},
                       {"kind", "refactor.rewrite"},
                       {"edit", {{"changes", {{document.uri, Json::array({edit})}}}}}});
    return;
  }
}

/// The word of a number of an enumeration, where the line has no comment yet.
void Server::add_value_action(Json& actions, Document const& document, std::size_t offset) {
  if (!is_list(document.path)) return;
  auto const& list = list_of(document);
  auto const* const line = list.line_at(offset);
  if (line == nullptr || !list.slice(line->trailer).empty()) return;
  auto const found = list.find(list.slice(line->name));
  auto const number = schema::read_real(list.slice(line->value));
  if (found.row == nullptr || number.status != schema::NumberStatus::good) return;
  auto const* const symbol = schema::symbol_of_number(*found.row, number.number);
  if (symbol == nullptr) return;
  auto const at = position_of(document.text, line->value.end, encoding_);
  Json const edit = {{"range", range_json(at, at)}, {"newText", "  ( " + std::string(symbol->word)}};
  actions.push_back(
      {{"title", render({.sentence = says::name_value, .arguments = {{"word", std::string(symbol->word)}}},
                        surroundings_.language)},
       {"kind", "refactor.rewrite"},
       {"edit", {{"changes", {{document.uri, Json::array({edit})}}}}}});
}

}  // namespace axisc::editor
