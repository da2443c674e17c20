#include "diagnostics/location.hpp"
#include "editor/open_list.hpp"
#include "editor/places.hpp"
#include "editor/server.hpp"
#include "schema/value.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace axisc::editor::says {

constexpr Sentence allow{"Allow {code} on this line", "{code} in dieser Zeile zulassen"};
constexpr Sentence explain{"Explain {code}", "{code} erklären"};
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
  auto const& commands = surroundings_.pages.commands;
  bool const can_explain = std::any_of(commands.begin(), commands.end(), [](Command const& command) {
    return command.name == "axisc.explain";
  });
  if (!can_explain) return;
  actions.push_back(
      {{"title", say(says::explain)},
       {"kind", "quickfix"},
       {"diagnostics", Json::array({shown})},
       {"command",
        {{"title", say(says::explain)}, {"command", "axisc.explain"}, {"arguments", {document.uri, code}}}}});
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
