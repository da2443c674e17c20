#include "axisc/asked/quantities.hpp"
#include "cli/manual/completions.hpp"
#include "cli/options/command_line.hpp"

#include <fmt/format.h>

namespace axisc::cli {

namespace {

std::string quoted_for_fish(std::string_view text) {
  std::string result;
  for (char const letter : text) {
    if (letter == '\'' || letter == '\\') result += '\\';
    result += letter;
  }
  return "'" + result + "'";
}

std::string offered_by_fish(OptionDescription const& option) {
  switch (offer_for(option)) {
    case Offer::values: return " -a " + quoted_for_fish(fmt::format("{}", fmt::join(option.values, " ")));
    case Offer::files: return " -F";
    case Offer::folders: return " -a '(__fish_complete_directories)'";
    case Offer::nothing: break;
  }
  return {};
}

std::string row(CommandDescription const& command, OptionDescription const& option) {
  std::string text = "complete -c axisc -n '__axisc_command " + command.name + "'";
  for (auto const& name : split_list(option.names)) {
    text += name.size() == 2 ? " -s " + name.substr(1) : " -l " + name.substr(2);
  }
  bool const needs_value = !option.shown.empty() && !option.shown.starts_with('[') && !option.names.empty();
  if (needs_value) text += offer_for(option) == Offer::files ? " -r" : " -x";
  if (needs_value || option.names.empty()) text += offered_by_fish(option);
  if (!option.names.empty()) text += " -d " + quoted_for_fish(meaning_of(option, Language::english));
  return text + "\n";
}

}  // namespace

std::string fish_completion(CommandDescription const& program, std::span<CommandDescription const> commands) {
  std::string text = R"(# Completions of fish for axisc, made of what --help prints.

# Whether the command of the line is $argv[1]; without an argument, whether there is none yet.
function __axisc_command
    set -l words (commandline -opc)
    set -l found
    set -l skip 0
    for word in $words[2..-1]
        if test $skip = 1
            set skip 0
        else if contains -- $word --lang --color
            set skip 1
        else if not string match -q -- '-*' $word
            set found $word
            break
        end
    end
    test "$found" = "$argv[1]"
end

complete -c axisc -f
)";
  for (auto const& option : program.options) text += row(program, option);
  std::string names;
  for (auto const& command : commands) {
    text += fmt::format("complete -c axisc -n __axisc_command -a {} -d {}\n", command.name,
                        quoted_for_fish(command.meaning.in(Language::english)));
    names += (names.empty() ? "" : " ") + command.name;
  }
  text += "complete -c axisc -n __axisc_command -a 'help version'\n";
  text += "complete -c axisc -n '__axisc_command help' -a " + quoted_for_fish(names) + "\n";
  for (auto const& command : commands) {
    for (auto const& option : command.options) text += row(command, option);
  }
  return text;
}

}  // namespace axisc::cli
