#include "cli/options/environment.hpp"

#include "axisc/settings/language_word.hpp"

namespace axisc::cli {

Language choose_language(std::span<std::string const> arguments) {
  constexpr std::string_view option = "--lang";
  std::optional<Language> chosen;
  for (std::size_t i = 0; i < arguments.size() && arguments[i] != "--"; ++i) {
    std::string_view const argument = arguments[i];
    std::string_view word;
    if (argument == option && i + 1 < arguments.size()) word = arguments[i + 1];
    if (argument.substr(0, option.size()) == option && argument.substr(option.size(), 1) == "=") {
      word = argument.substr(option.size() + 1);
    }
    if (auto const language = parse_language(word)) chosen = language;
  }
  if (chosen) return *chosen;
  for (auto const* const name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    auto const locale = system::environment_variable(name);
    if (!locale.empty()) return locale.substr(0, 2) == "de" ? Language::german : Language::english;
  }
  return parse_language(system::language_of_settings()).value_or(Language::english);
}

bool use_color(ColorChoice choice, system::Stream stream) {
  if (choice != ColorChoice::automatic) return choice == ColorChoice::always;
  return system::environment_variable("NO_COLOR").empty() && system::environment_variable("TERM") != "dumb" &&
         system::is_terminal(stream);
}

}  // namespace axisc::cli
