#include "grammar/nc_command.hpp"

#include "diagnostics/ascii.hpp"
#include "grammar/nc_command_def.hpp"

#include <algorithm>

namespace axisc::grammar {
namespace {

std::string_view view(block_syntax::Range const& range) {
  return {range.begin(), static_cast<std::size_t>(range.size())};
}

bool is_upper_case(std::string_view name) {
  return std::none_of(name.begin(), name.end(), [](char byte) { return byte >= 'a' && byte <= 'z'; });
}

/// As many bytes as the run of letters and digits at the front of `text` has.
std::size_t word_size(std::string_view text) {
  auto const* const end = std::find_if_not(
      text.begin(), text.end(), [](char byte) { return is(character::letter | character::digit, byte); });
  return static_cast<std::size_t>(end - text.begin());
}

/// One slip of the pen leaves the beginning or the end as it is.
bool resembles(std::string_view command, std::string_view beginning, std::string_view end) {
  auto const folded = ascii::upper_case(command);
  return folded.starts_with(beginning) || folded.ends_with(end);
}

/// The size of what may be a misspelt `#FILTER` or `#VIB GUARD` at the front of `text`; 0 for anything else.
std::size_t resembling_size(std::string_view text) {
  auto const skip_blanks = [text](std::size_t at) {
    return std::min(text.find_first_not_of(" \t", at), text.size());
  };
  std::size_t const first = skip_blanks(1);
  std::size_t const first_end = first + word_size(text.substr(first));
  if (first_end == first) return 0;
  std::string_view const word = text.substr(first, first_end - first);
  if (resembles(word, "FI", "ER") || resembles(word, "VIBG", "ARD") || resembles(word, "VIB_", "ARD")) {
    return first_end;
  }
  std::size_t const second = skip_blanks(first_end);
  std::size_t const second_end = second + word_size(text.substr(second));
  bool const is_guard =
      resembles(word, "VIB", "VIB") || resembles(text.substr(second, second_end - second), "GUARD", "ARD");
  return second != first_end && second_end != second && is_guard ? second_end : 0;
}

/// One command, from its `#` on.
class CommandReader {
 public:
  CommandReader(std::string_view text, std::uint32_t offset) : text_(text), offset_(offset) {}

  /// Afterwards `position` is after the command, or at its first problem.
  NcCommand read(char const*& position) {
    char const* const end = text_.data() + text_.size();
    block_syntax::CommandName name;
    block_syntax::command_name.parse(position, end, x3::unused, x3::unused, name);
    NcCommand command;
    std::string_view const whole = text_.substr(static_cast<std::size_t>(name.text.begin() - text_.data()));
    if (name.kind == CommandKind::other) command.resembling = span(whole.substr(0, resembling_size(whole)));
    command.kind = name.kind;
    command.name = span(view(name.text));
    if (command.kind == CommandKind::filter || command.kind == CommandKind::vibration_guard) {
      if (!is_upper_case(view(name.text))) {
        command.problem = {.kind = CommandProblemKind::letter_case, .span = command.name};
      }
      read_body(position, end, command);
    }
    return command;
  }

 private:
  void read_body(char const*& position, char const* end, NcCommand& command) const {
    block_syntax::CommandBody body;
    Failure<CommandProblemKind> failure;
    block_syntax::command_body.parse(position, end, x3::make_context<FailureTag>(failure), x3::unused, body);
    command.command_switch = body.command_switch;
    for (block_syntax::KeywordToken const& keyword : body.brackets.keywords) {
      command.keywords.push_back({.name = span(view(keyword.name)),
                                  .kind = keyword.value.kind,
                                  .value = span(view(keyword.value.text))});
    }
    if (failure.where == nullptr) return;
    position = failure.where;
    if (command.problem) return;
    command.problem = {.kind = failure.kind,
                       .span = failure.kind == CommandProblemKind::unclosed_bracket
                                   ? span(view(body.brackets.opening))
                                   : span(token_at(position, end))};
  }

  /// The part that a message points at: a string, or up to the next blank or whatever else ends a value, at
  /// least one byte.
  static std::string_view token_at(char const* first, char const* end) {
    char const* stop = first;
    if (!block_syntax::text.parse(stop, end, x3::unused, x3::unused, x3::unused)) {
      stop = std::find_if(first + 1, end, [](char byte) { return is(block_syntax::value_stops, byte); });
    }
    return {first, static_cast<std::size_t>(stop - first)};
  }

  [[nodiscard]] Span span(std::string_view token) const {
    auto const begin = offset_ + static_cast<std::uint32_t>(token.data() - text_.data());
    return {.begin = begin, .end = begin + static_cast<std::uint32_t>(token.size())};
  }

  std::string_view text_;
  std::uint32_t offset_;
};

}  // namespace

NcCommand read_nc_command(std::string_view block, std::size_t& position, std::uint32_t offset) {
  char const* first = block.data() + position;
  NcCommand command = CommandReader(block, offset).read(first);
  position = static_cast<std::size_t>(first - block.data());
  return command;
}

std::optional<NcCommand> parse_nc_command(std::string_view text) {
  char const* first = text.data();
  block_syntax::gap.parse(first, text.data() + text.size(), x3::unused, x3::unused, x3::unused);
  auto position = static_cast<std::size_t>(first - text.data());
  if (position == text.size() || text[position] != '#') return std::nullopt;
  NcCommand command = read_nc_command(text, position, 0);
  command.line = 1;
  return command;
}

}  // namespace axisc::grammar
