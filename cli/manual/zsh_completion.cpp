#include "axisc/asked/quantities.hpp"
#include "cli/manual/completions.hpp"
#include "cli/options/command_line.hpp"

#include <fmt/format.h>

namespace axisc::cli {

namespace {

/// A sentence in brackets within quotation marks.
std::string quoted_for_zsh(std::string_view text) {
  std::string result;
  for (char const letter : text) {
    if (letter == '\'') {
      result += "'\\''";
      continue;
    }
    if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') result += '\\';
    result += letter;
  }
  return result;
}

std::string action(OptionDescription const& option) {
  switch (offer_for(option)) {
    case Offer::values: {
      std::string words;
      for (auto const& value : option.values) words += (words.empty() ? "" : " ") + value;
      return "(" + words + ")";
    }
    case Offer::files: return "_files";
    case Offer::folders: return "_files -/";
    case Offer::nothing: break;
  }
  return " ";
}

/// One specification of _arguments for each name.
std::string specifications(OptionDescription const& option) {
  if (option.names.empty()) {
    return fmt::format(" \\\n        '*:{}:{}'", quoted_for_zsh(option.shown), action(option));
  }
  auto const names = split_list(option.names);
  bool const is_optional = option.shown.starts_with('[');
  std::string value;
  if (is_optional) {
    value = "::value:" + action(option);
  } else if (!option.shown.empty()) {
    value = ":" + quoted_for_zsh(option.shown) + ":" + action(option);
  }
  std::string text;
  for (auto const& name : names) {
    std::string exclusion;
    if (option.repeats) {
      exclusion = "*";
    } else if (names.size() > 1) {
      exclusion = fmt::format("({})", fmt::join(names, " "));
    }
    bool const is_letter = name.size() == 2;
    std::string_view const ending = is_optional ? "=-" : is_letter ? "+" : "=";
    text += fmt::format(" \\\n        '{}{}{}[{}]{}'", exclusion, name, value.empty() ? "" : ending,
                        quoted_for_zsh(meaning_of(option, Language::english)), value);
  }
  return text;
}

std::string specifications(CommandDescription const& command) {
  std::string text;
  for (auto const& option : command.options) text += specifications(option);
  return text;
}

}  // namespace

std::string zsh_completion(CommandDescription const& program, std::span<CommandDescription const> commands) {
  std::string rows;
  std::string cases;
  for (auto const& command : commands) {
    rows += fmt::format("    '{}:{}'\n", command.name, quoted_for_zsh(command.meaning.in(Language::english)));
    cases += fmt::format("    ({})\n      _arguments -s{} ;;\n", command.name, specifications(command));
  }
  return fmt::format(R"(#compdef axisc
# Completions of zsh for axisc, made of what --help prints.

_axisc_commands() {{
  local -a commands=(
{}  )
  _describe -t commands command commands
}}

_axisc() {{
  local curcontext=$curcontext state line
  _arguments -C{} \
        '1:command:_axisc_commands' \
        '*:: :->arguments' && return
  case $line[1] in
    (help) _arguments '1:command:_axisc_commands' ;;
{}  esac
}}

_axisc "$@"
)",
                     rows, specifications(program), cases);
}

}  // namespace axisc::cli
