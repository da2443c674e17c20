#include "editor/capabilities/tokens.hpp"

#include "editor/reading/open_machines.hpp"

#include <array>

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

enum class TokenType : std::uint8_t { property, number, enumeration_member, variable, string, comment };
constexpr std::array type_names = {"property", "number", "enumMember", "variable", "string", "comment"};
/// The control ignores it, or does not know the name.
constexpr unsigned ignored = 1;
constexpr std::array modifier_names = {"deprecated"};

/// Tokens in text order, each relative to the one before, as the protocol requires.
class Tokens {
 public:
  explicit Tokens(TextLines const& lines) : lines_(lines) {}

  void add(std::size_t offset, std::string_view text, TokenType type, unsigned modifiers = 0) {
    if (text.empty()) return;
    auto const at = lines_.position(offset);
    data_.push_back(at.line - last_.line);
    data_.push_back(at.character - (at.line == last_.line ? last_.character : 0));
    data_.push_back(lines_.units_of(text));
    data_.push_back(static_cast<unsigned>(type));
    data_.push_back(modifiers);
    last_ = at;
  }
  [[nodiscard]] Json take() { return {{"data", std::move(data_)}}; }

 private:
  TextLines const& lines_;
  TextPosition last_;
  Json data_ = Json::array();
};

bool begins_comment(std::string_view text) {
  return text.starts_with('#') || text.starts_with('(') || text.starts_with(';') || text.starts_with("/*");
}

TokenType type_of(grammar::Assignment const& line, schema::Parameter const* parameter) {
  using grammar::ValueKind;
  switch (line.kind) {
    case ValueKind::integer:
    case ValueKind::hexadecimal:
    case ValueKind::real:
    case ValueKind::decimal_comma:
    case ValueKind::malformed_number:
      return parameter != nullptr && !parameter->symbols.empty() ? TokenType::enumeration_member
                                                                 : TokenType::number;
    case ValueKind::reference: return TokenType::variable;
    case ValueKind::word:
      return parameter != nullptr && parameter->type == schema::DataType::string && parameter->symbols.empty()
                 ? TokenType::string
                 : TokenType::enumeration_member;
    case ValueKind::quoted:
    case ValueKind::other: break;
  }
  return TokenType::string;
}

/// Segments, and indices in brackets.
void add_name(Tokens& tokens, std::size_t offset, std::string_view name, unsigned modifiers) {
  std::size_t begin = 0;
  bool is_index = false;
  for (std::size_t at = 0; at <= name.size(); ++at) {
    bool const ends = at == name.size() || name[at] == '[' || name[at] == ']' || name[at] == '.';
    if (!ends) continue;
    tokens.add(offset + begin, name.substr(begin, at - begin),
               is_index ? TokenType::number : TokenType::property, modifiers);
    is_index = at < name.size() && name[at] == '[';
    begin = at + 1;
  }
}

/// A line without an assignment.
void add_rest(Tokens& tokens, std::size_t offset, std::string_view line) {
  auto const begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return;
  auto const text = line.substr(begin, line.find_last_not_of(" \t") + 1 - begin);
  tokens.add(offset + begin, text, TokenType::comment, begins_comment(text) ? 0 : ignored);
}

}  // namespace

Json token_legend() {
  return {{"tokenTypes", type_names}, {"tokenModifiers", modifier_names}};
}

Json tokens(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  if (!is_list(asked.path)) return {{"data", Json::array()}};
  auto const& list = machines.list_of(asked);
  TextLines const lines(asked.text, machines.encoding());
  Tokens found(lines);
  auto next = list.tree().assignments.begin();
  auto const end = list.tree().assignments.end();
  for (std::size_t i = 0; i < lines.count(); ++i) {
    auto const line = lines.line(i);
    auto const line_end = lines.begin(i) + line.size();
    if (next == end || next->name.begin >= line_end || next->name.begin < lines.begin(i)) {
      add_rest(found, lines.begin(i), line);
      continue;
    }
    auto const name = list.slice(next->name);
    auto const* const row = list.find(name).row;
    add_name(found, next->name.begin, name, row == nullptr ? ignored : 0);
    found.add(next->value.begin, list.slice(next->value), type_of(*next, row));
    auto const trailer = list.slice(next->trailer);
    found.add(next->trailer.begin, trailer, TokenType::comment, begins_comment(trailer) ? 0 : ignored);
    ++next;
  }
  return found.take();
}

}  // namespace axisc::editor
