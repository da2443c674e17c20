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

/// What to append to a comment so that it allows a code.
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

/// A value with its unit: "20 ms", "42.5Hz", "0,1 kHz".
struct Measured {
  std::string text;  ///< as written
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
  std::string unit(validator::unit_word(std::string_view(text).substr(begin)));
  if (!validator::is_unit(unit)) return std::nullopt;
  text.resize(begin + unit.size());
  return Measured{.text = std::move(text), .number = number.number, .unit = std::move(unit)};
}

/// A workspace edit.
Json insertion(OpenDocument const& document, Json const& range, std::string const& text) {
  return {{"changes", {{document.uri, Json::array({{{"range", range}, {"newText", text}}})}}}};
}

struct Rewrite {
  std::string title;
  std::size_t at = 0;
  std::string text;
};

/// The original value is kept as a comment.
std::optional<Rewrite> conversion(OpenMachines& machines, OpenList const& list,
                                  grammar::Assignment const& line, schema::Parameter const& row) {
  auto const value = measured(list, line);
  if (!value || !schema::is_number(row.type)) return std::nullopt;
  // Without a machine, the axis may be of either type.
  for (auto const unit : {row.unit_translatory, row.unit_rotary}) {
    auto const ratio = validator::unit_ratio(value->unit, unit);
    if (!ratio) continue;
    bool const is_right =
        *ratio == 1 && schema::read_real(list.slice(line.value)).status == schema::NumberStatus::good;
    auto const number = validator::converted_number(value->number, *ratio, schema::is_integer(row.type));
    if (is_right || number.empty()) return std::nullopt;
    auto title = machines.say(
        says::convert,
        {{"written", value->text}, {"number", number}, {"unit", validator::raw_unit_name(unit)}});
    return Rewrite{.title = std::move(title), .at = line.value.begin, .text = number + " ( "};
  }
  return std::nullopt;
}

/// Only for lines without a comment.
std::optional<Rewrite> word(OpenMachines& machines, OpenList const& list, grammar::Assignment const& line,
                            schema::Parameter const& row) {
  auto const number = schema::read_real(list.slice(line.value));
  if (!list.slice(line.trailer).empty() || number.status != schema::NumberStatus::good) return std::nullopt;
  auto const* const symbol = schema::symbol_of_number(row, number.number);
  if (symbol == nullptr) return std::nullopt;
  std::string const text(symbol->word);
  return Rewrite{
      .title = machines.say(says::name_value, {{"word", text}}), .at = line.value.end, .text = "  ( " + text};
}

}  // namespace

void add_finding_actions(Json& actions, OpenMachines& machines, OpenDocument const& document,
                         Finding const& finding, Json const& shown) {
  std::string const code = code_text(finding.code);
  auto const add = [&](SentenceRef title, std::string const& what, Json does) {
    actions.push_back({{"title", machines.say(title, {{"code", code}})},
                       {"kind", "quickfix"},
                       {"diagnostics", Json::array({shown})},
                       {what, std::move(does)}});
  };
  if (is_list(document.path)) {
    auto const& list = machines.list_of(document);
    TextLines const lines(document.text, machines.encoding());
    auto const line = shown["range"]["start"]["line"].get<std::size_t>();
    auto const* const assignment = line < lines.count() ? list.line_at(lines.begin(line)) : nullptr;
    // The allowance of a line that is not a name with a value goes on the line above.
    auto const comment = assignment == nullptr ? std::string_view() : list.slice(assignment->trailer);
    bool const is_beside = assignment != nullptr && (comment.empty() || is_comment(assignment->trailer_kind));
    auto const at = is_beside ? lines.position(end_of(*assignment)) : TextPosition{.line = line};
    auto const text = is_beside ? allowance(comment, code) : "( " + std::string(directive) + code + "\n";
    add(says::allow, "edit", insertion(document, range_json(at, at), text));
  }
  add(says::explain, "command",
      {{"title", machines.say(says::explain, {{"code", code}})},
       {"command", "axisc.explain"},
       {"arguments", {document.uri, code}}});
}

void add_rewrites(Json& actions, OpenMachines& machines, OpenDocument const& document, std::size_t offset) {
  if (!is_list(document.path)) return;
  auto const& list = machines.list_of(document);
  auto const* const line = list.line_at(offset);
  if (line == nullptr) return;
  auto const* const row = list.find(list.slice(line->name)).row;
  if (row == nullptr) return;
  for (auto const& rewrite : {word(machines, list, *line, *row), conversion(machines, list, *line, *row)}) {
    if (!rewrite) continue;
    auto const at = machines.range(document, rewrite->at, rewrite->at);
    actions.push_back({{"title", rewrite->title},
                       {"kind", "refactor.rewrite"},
                       {"edit", insertion(document, at, rewrite->text)}});
  }
}

}  // namespace axisc::editor
