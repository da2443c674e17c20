#include "cli/options/command_line.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/version.hpp"
#include "cli/help/help_page.hpp"
#include "cli/options/help_text.hpp"
#include "cli/options/invocation.hpp"
#include "cli/options/sentences.hpp"
#include "diagnostics/joined.hpp"
#include "presentation/text_table.hpp"
#include "schema/closest_word.hpp"

#include <algorithm>
#include <array>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace axisc::cli::says {

constexpr Sentence of_kinds{"{option} belongs to --kind {kinds}", "{option} gehört zu --kind {kinds}"};
constexpr Sentence only_with{"{option} belongs to {other}: give {other} as well",
                             "{option} gehört zu {other}: auch {other} angeben"};
constexpr Sentence not_with{"{option} cannot be used together with {other}",
                            "{option} geht nicht zusammen mit {other}"};
constexpr Sentence unknown_option{
    "\"axisc {command}\" has no option {option}; `axisc {command} --help` lists them",
    "\"axisc {command}\" hat keine Option {option}; `axisc {command} --help` nennt alle"};
constexpr Sentence unknown_option_meant{
    "\"axisc {command}\" has no option {option}; did you mean {meant}?",
    "\"axisc {command}\" hat keine Option {option}; war {meant} gemeint?"};
constexpr Sentence option_value_missing{
    "option {option} needs a value; `axisc {command} --help` shows how it is written",
    "Option {option} braucht einen Wert; `axisc {command} --help` zeigt die Schreibweise"};
constexpr Sentence option_without_value{
    "option {option} takes no value; `axisc {command} --help` shows how it is written",
    "Option {option} nimmt keinen Wert; `axisc {command} --help` zeigt die Schreibweise"};
constexpr Sentence superfluous_argument{
    "\"{argument}\" is one argument too many; `axisc {command} --help` shows the usage",
    "\"{argument}\" ist ein Argument zu viel; `axisc {command} --help` zeigt den Aufruf"};
constexpr Sentence argument_missing{"{argument} is missing; `axisc {command} --help` shows the usage",
                                    "{argument} fehlt; `axisc {command} --help` zeigt den Aufruf"};
constexpr Sentence option_color{"colours; auto: on a terminal, unless NO_COLOR is set",
                                "Farben; auto: auf einem Terminal, sofern NO_COLOR nicht gesetzt ist"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

/// Whether one of the arguments could be meant for the option.
bool is_named(std::string_view names, std::span<std::string const> words) {
  auto const known = split_list(names);
  return std::any_of(known.begin(), known.end(), [&](std::string const& name) {
    bool const is_letter = name.size() == 2;  // others may stand before it: -qj2
    return std::any_of(words.begin(), words.end(), [&](std::string const& word) {
      return is_letter ? word.starts_with('-') && word.find(name.back()) != std::string::npos
                       : word.starts_with(name);
    });
  });
}

/// After `--` every word is a file: `@x.lis` is one of that name, not a response file.
std::vector<std::string> with_files(std::span<std::string const> arguments) {
  std::vector<std::string> words(arguments.begin(), arguments.end());
  for (auto word = std::find(words.begin(), words.end(), "--"); word != words.end(); ++word) {
    if (word->starts_with('@')) word->insert(0, "./");
  }
  return words;
}

/// The parser's messages begin with a name, followed by a colon, a blank, or nothing.
bool is_about(std::string_view complaint, std::string_view name) {
  if (!complaint.starts_with(name)) return false;
  std::string_view const rest = complaint.substr(name.size());
  return rest.empty() || rest.front() == ':' || rest.front() == ' ';
}

}  // namespace

/// What follows an option's name; an argument has none.
enum class CommandLine::Takes : std::uint8_t {
  argument,
  arguments,
  nothing,
  value_or_nothing,
  value,
  values
};

struct CommandLine::Declared : OptionDescription {
  Takes takes{};
  std::function<void(std::vector<std::string> const&)> take;
  CLI::Option* option = nullptr;  ///< none where no word names it
  std::string_view only_with = {}, not_with = {};

  [[nodiscard]] bool is_given() const { return option != nullptr && option->count() > 0; }
};

struct CommandLine::Parser {
  CLI::App app;
  std::vector<Declared> declared;
};

CommandLine::CommandLine(std::string_view command, Language language)
    : command_(command), language_(language), parser_(std::make_unique<Parser>()) {
  // A path that begins with a slash is never an option.
  parser_->app.allow_windows_style_options(false);
  flag("-h,--help", wants_help_, says::option_help);
  flag("-V,--version", wants_version_, says::option_version);
  choice("--lang", {{"en", Language::english}, {"de", Language::german}}, language_, says::option_lang);
  choice("--color",
         {{"auto", ColorChoice::automatic}, {"always", ColorChoice::always}, {"never", ColorChoice::never}},
         color_, says::option_color);
}

CommandLine::~CommandLine() = default;

CommandLine::Declared& CommandLine::declare(Takes takes, std::string_view names, std::string_view shown,
                                            SentenceRef meaning) {
  auto& row = parser_->declared.emplace_back();
  row.takes = takes;
  row.names = names;
  row.shown = shown;
  row.meaning = meaning;
  row.only_for = only_for_;
  row.only_with = only_with_;
  row.not_with = not_with_;
  // Placeholders of arguments are capitals: "CODE|PARAMETER".
  bool const are_values =
      !names.empty() || shown.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string_view::npos;
  if (are_values && shown.find('|') != std::string_view::npos) row.values = split_list(shown, '|');
  return row;
}

void CommandLine::argument(std::string_view shown, std::optional<std::string>& target, SentenceRef meaning,
                           std::vector<std::string> values) {
  auto& row = declare(Takes::argument, {}, shown, meaning);
  row.take = [&target](std::vector<std::string> const& given) { target = given.front(); };
  if (!values.empty()) row.values = std::move(values);
}

void CommandLine::arguments(std::string_view shown, std::vector<std::string>& target, SentenceRef meaning) {
  declare(Takes::arguments, {}, shown, meaning).take = [&target](std::vector<std::string> const& given) {
    target = given;
  };
}

void CommandLine::flag(std::string_view names, bool& target, SentenceRef meaning) {
  declare(Takes::nothing, names, {}, meaning).take = [&target](std::vector<std::string> const&) {
    target = true;
  };
}

void CommandLine::flag_with_value(std::string_view names, std::string_view shown,
                                  std::optional<std::string>& target, SentenceRef meaning) {
  // The parser gives "true" for a flag without a value.
  auto& row = declare(Takes::value_or_nothing, names, shown, meaning);
  row.take = [&target](std::vector<std::string> const& given) {
    target = given.back() == "true" ? std::string() : given.back();
  };
  row.values = {std::string(shown.substr(2, shown.size() - 3))};
}

void CommandLine::value(std::string_view names, std::string_view shown, std::optional<std::string>& target,
                        SentenceRef meaning, std::vector<std::string> values) {
  auto& row = declare(Takes::value, names, shown, meaning);
  row.take = [&target](std::vector<std::string> const& given) { target = given.back(); };
  if (!values.empty()) row.values = std::move(values);
}

void CommandLine::values(std::string_view names, std::string_view shown, std::vector<std::string>& target,
                         SentenceRef meaning) {
  auto& row = declare(Takes::values, names, shown, meaning);
  row.repeats = true;
  row.take = [&target](std::vector<std::string> const& given) { target = given; };
}

void CommandLine::choice_of(std::string_view names, std::vector<std::string_view> words,
                            std::function<void(std::size_t)> take, SentenceRef meaning) {
  auto shown = joined(words, "|");
  declare(Takes::value, names, shown, meaning).take =
      [name = std::string(names), words = std::move(words),
       take = std::move(take)](std::vector<std::string> const& given) {
        auto const found = std::find(words.begin(), words.end(), given.back());
        if (found == words.end()) {
          throw Failure(
              {says::bad_choice, {{"option", name}, {"value", given.back()}, {"choices", joined(words)}}});
        }
        take(static_cast<std::size_t>(found - words.begin()));
      };
}

void CommandLine::build(Declared& row) {
  auto& app = parser_->app;
  switch (row.takes) {
    case Takes::argument: row.option = app.add_option("argument")->expected(1); break;
    case Takes::arguments:
      row.option =
          app.add_option("arguments")->expected(-1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
      break;
    case Takes::nothing: row.option = app.add_flag(row.names)->disable_flag_override(); break;
    case Takes::value_or_nothing:
      row.option = app.add_flag(row.names)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
      break;
    case Takes::value: row.option = app.add_option(row.names)->take_last(); break;
    case Takes::values:
      row.option = app.add_option(row.names)->type_size(1)->expected(1, 1)->multi_option_policy(
          CLI::MultiOptionPolicy::TakeAll);
      break;
  }
}

void CommandLine::refuse_unknown() const {
  auto remaining = parser_->app.remaining();
  std::erase(remaining, "--");
  if (remaining.empty()) return;
  auto const unknown = remaining.front().substr(0, remaining.front().find('='));
  if (unknown.substr(0, 1) != "-") {
    throw Failure({says::superfluous_argument, {{"argument", remaining.front()}, {"command", command_}}});
  }
  std::vector<std::string_view> known;
  for (auto const& row : parser_->declared) {
    for (std::string_view rest = row.names; !rest.empty();) {
      auto const comma = std::min(rest.find(','), rest.size());
      known.push_back(rest.substr(0, comma));
      rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
  }
  // Of one letter everything is close to something.
  auto const meant = unknown.size() <= 2 ? std::string_view() : schema::closest_word(unknown, known);
  throw Failure({meant.empty() ? says::unknown_option : says::unknown_option_meant,
                 {{"option", unknown}, {"command", command_}, {"meant", std::string(meant)}}});
}

void CommandLine::refuse_value(std::string_view complaint) const {
  for (auto const& row : parser_->declared) {
    if (row.option == nullptr) continue;
    auto const name = row.option->get_name();
    auto const bare = name.substr(std::min(name.find_first_not_of('-'), name.size()));
    if (!is_about(complaint, name) && !is_about(complaint, bare)) continue;
    throw Failure({row.shown.empty() ? says::option_without_value : says::option_value_missing,
                   {{"option", name}, {"command", command_}}});
  }
  throw Failure({says::unexpected, {{"reason", std::string(complaint)}}});
}

std::optional<std::string> CommandLine::read(std::span<std::string const> arguments) {
  parser_->app.set_help_flag();
  parser_->app.allow_extras();
  for (auto& row : parser_->declared) {
    if (row.names.empty() || is_named(row.names, arguments)) build(row);
  }
  // The parser reads the vector from its end.
  auto reversed = with_files(arguments);
  std::reverse(reversed.begin(), reversed.end());
  try {
    parser_->app.parse(reversed);
  } catch (CLI::ParseError const& error) {
    refuse_value(error.what());
  }
  for (auto const& row : parser_->declared) {
    if (row.is_given() && (row.names == "-h,--help" || row.names == "-V,--version")) row.take({});
  }
  if (wants_help_) return help();
  if (wants_version_) return version_text();
  refuse_unknown();
  refuse_mixture();
  for (auto const& row : parser_->declared) {
    if (row.is_given()) row.take(row.option->results());
  }
  return std::nullopt;
}

bool CommandLine::answers(Invocation const& invocation) {
  if (invocation.description != nullptr) {
    *invocation.description = {.name = command_};
    for (auto const& row : parser_->declared) invocation.description->options.push_back(row);
    return true;
  }
  auto const text = read(invocation.arguments);
  if (text) invocation.streams.out.write(*text);
  return text.has_value();
}

void CommandLine::require(bool given, std::string_view argument) const {
  if (given) return;
  throw Failure(
      {says::argument_missing, {{"argument", placeholder_in(language_, argument)}, {"command", command_}}});
}

void CommandLine::refuse_mixture() const {
  auto const is_given = [this](std::string_view names) {
    return std::any_of(parser_->declared.begin(), parser_->declared.end(),
                       [&](Declared const& row) { return row.names == names && row.is_given(); });
  };
  for (auto const& row : parser_->declared) {
    if (!row.is_given()) continue;
    if (!row.only_with.empty() && !is_given(row.only_with)) {
      throw Failure({says::only_with, {{"option", row.names}, {"other", row.only_with}}});
    }
    if (!row.not_with.empty() && is_given(row.not_with)) {
      throw Failure({says::not_with, {{"option", row.names}, {"other", row.not_with}}});
    }
  }
}

void CommandLine::refuse_others(std::string_view kind) const {
  for (auto const& row : parser_->declared) {
    auto const kinds = split_list(row.only_for);
    bool const fits = kinds.empty() || std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
    if (fits || !row.is_given()) continue;
    throw Failure({says::of_kinds, {{"option", row.names}, {"kinds", row.only_for}}});
  }
}

std::string CommandLine::help() const {
  auto const say = [this](SentenceRef text) { return render({text}, language_); };
  auto const page = help_page(command_, language_);
  auto const width = help_width();
  std::string usage = say(says::help_usage) + ": axisc " + command_ + " [" + say(says::help_options) + "]";
  std::string rows;
  std::string options;
  for (auto const& row : parser_->declared) {
    auto const heading = heading_of(row, language_);
    if (row.names.empty()) usage += " " + heading;
    (row.names.empty() ? rows : options) += help_row(heading, meaning_of(row, language_), width);
  }
  return help_paragraphs(page.purpose, width) + "\n" + help_paragraphs(usage, width) + "\n" + rows + "\n" +
         say(says::help_options_heading) + ":\n" + options + "\n" + help_paragraphs(page.examples, width);
}

}  // namespace axisc::cli
