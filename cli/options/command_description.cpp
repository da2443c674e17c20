#include "cli/options/command_description.hpp"

#include <algorithm>
#include <array>

namespace axisc::cli {

namespace {

struct Placeholder {
  std::string_view english;
  std::string_view german;
};

/// The placeholders that differ between the languages.
constexpr std::array<Placeholder, 27> placeholders = {{
    {"AXIS", "ACHSE"},       {"COLUMN", "SPALTE"},
    {"COMMAND", "BEFEHL"},   {"CYCLE", "ZYKLUS"},
    {"DAMPING", "DÄMPFUNG"}, {"DEGREES", "GRAD"},
    {"FILE", "DATEI"},       {"FOLDER", "ORDNER"},
    {"IMAGE", "ABBILD"},     {"INPUT", "EINGABE"},
    {"KEY", "SCHLÜSSEL"},    {"KIND", "ART"},
    {"MACHINE", "MASCHINE"}, {"MM_PER_MIN", "MM_JE_MIN"},
    {"NEW", "NEU"},          {"OLD", "ALT"},
    {"OTHER", "ANDERE"},     {"OUT", "ZIEL"},
    {"PART", "TEIL"},        {"PLANT", "STRECKE"},
    {"POSITION", "LAGE"},    {"RECORDING", "AUFZEICHNUNG"},
    {"SIZE", "GRÖSSE"},      {"TIME", "ZEIT"},
    {"VALUE", "WERT"},       {"WORD", "WORT"},
    {"WORDS", "WÖRTER"},
}};

}  // namespace

std::string placeholder_in(Language language, std::string_view shown) {
  if (language == Language::english) return std::string(shown);
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ_-";
  std::string text;
  while (!shown.empty()) {
    auto const length = std::min(shown.find_first_not_of(letters), shown.size());
    auto const word = shown.substr(0, length);
    auto const* const known =
        std::find_if(placeholders.begin(), placeholders.end(),
                     [&](Placeholder const& placeholder) { return placeholder.english == word; });
    text += known == placeholders.end() ? word : known->german;
    shown.remove_prefix(length);
    auto const rest = std::min(shown.find_first_of(letters), shown.size());
    text += shown.substr(0, rest);
    shown.remove_prefix(rest);
  }
  return text;
}

std::string heading_of(OptionDescription const& option, Language language) {
  auto shown = placeholder_in(language, option.shown);
  if (option.names.empty()) return shown;
  std::string heading = option.names;
  if (auto const comma = heading.find(','); comma != std::string::npos) heading.insert(comma + 1, 1, ' ');
  if (!shown.empty()) heading += (shown.front() == '[' ? "" : " ") + shown;
  return heading;
}

std::string page_name(CommandDescription const& command) {
  return command.name.empty() ? "axisc" : "axisc-" + command.name;
}

Offer offer_for(OptionDescription const& option) {
  if (!option.values.empty()) return Offer::values;
  auto const names = [&](std::string_view word) { return option.shown.find(word) != std::string::npos; };
  if (names("FOLDER")) return Offer::folders;
  constexpr std::array<std::string_view, 9> files{"FILE", "IMAGE", "INPUT", "KEY",      "MACHINE",
                                                  "OLD",  "OTHER", "OUT",   "RECORDING"};
  bool const is_file =
      std::any_of(files.begin(), files.end(), names) || names("PART.nc") || names("PLANT.json");
  return is_file ? Offer::files : Offer::nothing;
}

std::string meaning_of(OptionDescription const& option, Language language) {
  std::string const meaning(option.meaning.in(language));
  return option.only_for.empty() ? meaning : meaning + " (--kind " + option.only_for + ")";
}

}  // namespace axisc::cli
