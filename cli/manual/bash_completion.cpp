#include "axisc/asked/quantities.hpp"
#include "cli/manual/completions.hpp"
#include "cli/options/command_line.hpp"
#include "diagnostics/joined.hpp"

#include <map>

#include <fmt/format.h>

namespace axisc::cli {

namespace {

constexpr std::string_view begin = R"(# Completions of bash for axisc, made of what --help prints.

_axisc() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= options= offered= i
  COMPREPLY=()
  [[ " ${COMP_WORDS[*]:0:COMP_CWORD} " != *' -- '* ]] || return 0
  # For readline "=" is a word of its own.
  if [[ $word == = ]]; then
    word= before+==
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}=
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${COMP_WORDS[i]} in
      --lang | --color) [[ ${COMP_WORDS[i + 1]} != = ]] || ((++i)); ((++i)) ;;
      -* | =) ;;
      *) command=${COMP_WORDS[i]}; break ;;
    esac
  done
  case "$command $before" in
)";

constexpr std::string_view end = R"(  esac
  [[ $word != -* || -z $options ]] || offered=$options
  case $offered in
    files) return 0 ;;
    folders) compopt -o dirnames +o default +o bashdefault; return 0 ;;
    nothing) compopt +o default +o bashdefault; return 0 ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$offered" -- "$word")
  compopt +o default +o bashdefault
}

complete -o bashdefault -o default -F _axisc axisc
)";

std::string_view word_of(Offer offer) {
  switch (offer) {
    case Offer::files: return "files";
    case Offer::folders: return "folders";
    case Offer::nothing:
    case Offer::values: break;
  }
  return "nothing";
}

std::string offered_by_bash(OptionDescription const& option) {
  return option.values.empty() ? std::string(word_of(offer_for(option))) : joined(option.values, " ");
}

/// The words before the place of a value, each with what may follow: "lint --kind" offers "axis channel …".
void append_values(std::map<std::string, std::string>& cases, CommandDescription const& command) {
  for (auto const& option : command.options) {
    if (option.names.empty() || option.shown.empty()) continue;
    bool const is_optional = option.shown.starts_with('[');
    for (auto const& name : split_list(option.names)) {
      auto& patterns = cases[offered_by_bash(option)];
      auto const before = command.name + " " + name;
      if (!is_optional) patterns += (patterns.empty() ? "'" : " | '") + before + "'";
      patterns += (patterns.empty() ? "'" : " | '") + before + "='";
    }
  }
}

/// What stands for itself: the options of a command, and what its arguments are.
std::string own_case(CommandDescription const& command, std::string arguments) {
  std::string options;
  for (auto const& option : command.options) {
    for (auto const& name : split_list(option.names)) options += " " + name;
    if (option.names.empty()) arguments = offered_by_bash(option);
  }
  return "    '" + command.name + " '*) options='" + options + "' offered='" + arguments + "' ;;\n";
}

}  // namespace

std::string bash_completion(CommandDescription const& program, std::span<CommandDescription const> commands) {
  std::map<std::string, std::string> cases;
  std::string own;
  std::string names;
  append_values(cases, program);
  for (auto const& command : commands) {
    append_values(cases, command);
    own += own_case(command, "nothing");
    names += command.name + " ";
  }
  std::string text(begin);
  for (auto const& [values, patterns] : cases) {
    text += fmt::format("    {}) offered='{}' ;;\n", patterns, values);
  }
  return text + own + "    'help '*) offered='" + names + "' ;;\n" +
         own_case(program, names + "help version") + std::string(end);
}

}  // namespace axisc::cli
