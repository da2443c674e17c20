#include "axisc/settings/settings.hpp"
#include "configuration/machine/motion_words.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/terminal.hpp"
#include "presentation/text_table.hpp"

namespace axisc::says {

constexpr Sentence from_command_line{"command line", "Befehlszeile"};
constexpr Sentence from_default{"default", "Standardwert"};
constexpr Sentence cycle_time_default{"from the machine file; otherwise 1000 is assumed",
                                      "aus der Maschinendatei; sonst wird 1000 angenommen"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string say(SentenceRef text, Language language) {
  return render({text}, language);
}

std::string joined(std::vector<Code> const& codes) {
  std::string text;
  for (Code const code : codes) text += (text.empty() ? "" : ", ") + code_text(code);
  return text;
}

}  // namespace

std::string describe_settings(std::string const& input, validator::CheckOptions const& command_line,
                              std::vector<std::string> const& schema_files, Settings const* settings,
                              Language language) {
  auto const from_command_line = say(says::from_command_line, language);
  auto const from_default = say(says::from_default, language);
  auto const from_file = settings ? settings->file : std::string();
  std::vector<std::vector<std::string>> rows;
  auto const add = [&](std::string const& name, std::string const& value, std::string const& origin) {
    rows.push_back({name, value, origin});
  };
  if (command_line.cycle_time) {
    add("cycle_time_us", format_exact(command_line.cycle_time->microseconds()), from_command_line);
  } else if (settings && settings->cycle_time) {
    add("cycle_time_us", format_exact(settings->cycle_time->microseconds()), from_file);
  } else {
    add("cycle_time_us", say(says::cycle_time_default, language), from_default);
  }
  if (command_line.build) {
    add("build", to_text(*command_line.build), from_command_line);
  } else if (settings && settings->build) {
    add("build", to_text(*settings->build), from_file);
  } else {
    add("build", "-", from_default);
  }
  add("language", language == Language::german ? "de" : "en",
      settings && settings->language ? from_file : from_default);
  if (command_line.kind) add("kind", std::string(row_of(*command_line.kind).word), from_command_line);
  if (!command_line.disabled.empty()) add("disable", joined(command_line.disabled), from_command_line);
  if (settings) {
    auto const& readings = settings->readings;
    auto const add_reading = [&](std::string const& name, auto reading) {
      if (reading != decltype(reading)::documented) add(name, std::string(word_of(reading)), from_file);
    };
    add_reading("design: filters", readings.filters);
    add_reading("design: kernels", readings.kernels);
    add_reading("design: vibration_guard", readings.guard);
    add_reading("design: cycle_time", readings.cycle_time);
    machine::for_each_reading(settings->motion,
                              [&](std::string const& key, auto const& words, std::size_t i) {
                                if (i != 0) add("motion: " + key, std::string(words.at(i)), from_file);
                              });
    for (auto const& file : settings->schema_files) add("schema", file, from_file);
  }
  for (auto const& file : schema_files) add("schema", file, from_command_line);
  if (settings) {
    if (!settings->disabled.empty()) add("disable", joined(settings->disabled), from_file);
    for (auto const& rule : settings->paths) {
      if (!rule.disabled.empty()) add("paths: " + rule.pattern, joined(rule.disabled), from_file);
      if (rule.kind) add("kind: " + rule.pattern, std::string(row_of(*rule.kind).word), from_file);
    }
    for (auto const& pattern : settings->included) add("include", pattern, from_file);
    for (auto const& pattern : settings->excluded) add("exclude", pattern, from_file);
    for (auto const& [code, severity] : settings->severities) {
      add("severity: " + code_text(code), std::string(severity_name(severity)), from_file);
    }
  }
  return printable(input) + "\n" + presentation::text_table(rows, 2);
}

}  // namespace axisc
