#include "cli/options/environment.hpp"

#include <cstdlib>
#include <unistd.h>

namespace axisc::cli {

namespace {

/// Empty when it is not set.
std::string_view environment(char const* name) {
  char const* const value =
      std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing changes the environment
  return value == nullptr ? std::string_view{} : value;
}

}  // namespace

std::optional<Language> parse_language(std::string_view word) {
  if (word == "en") return Language::english;
  if (word == "de") return Language::german;
  return std::nullopt;
}

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
    auto const locale = environment(name);
    if (!locale.empty()) return locale.substr(0, 2) == "de" ? Language::german : Language::english;
  }
  return Language::english;
}

bool use_color(ColorChoice choice, int descriptor) {
  if (choice != ColorChoice::automatic) return choice == ColorChoice::always;
  return environment("NO_COLOR").empty() && environment("TERM") != "dumb" && ::isatty(descriptor) == 1;
}

}  // namespace axisc::cli
