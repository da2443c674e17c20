#include "cli/command_line.hpp"

#include "axisrt.h"
#include "cli/failure.hpp"
#include "cli/suggestion.hpp"
#include "cli/text_table.hpp"
#include "runtime/format/image_format.h"

#include <algorithm>

namespace axisc::cli {

namespace {

constexpr std::size_t meaning_column = 30;
constexpr std::size_t line_width = 100;
// The constructor declares them first.
constexpr std::size_t help_option = 0;
constexpr std::size_t version_option = 1;

using Given = std::vector<std::string>;

std::string joined(std::vector<std::string_view> const& words, std::string_view separator) {
  std::string text;
  for (auto const word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

}  // namespace

CommandLine::CommandLine(std::string_view command, Text purpose, Text examples, Language language)
    : command_(command), purpose_(purpose), examples_(examples), language_(language) {
  flag("-h,--help", wants_help_, Text::cli_opt_help);
  flag("--version", wants_version_, Text::cli_opt_version);
  choice("--lang", {{"en", Language::english}, {"de", Language::german}}, language_, Text::cli_opt_lang);
  choice("--color",
         {{"auto", ColorChoice::automatic}, {"always", ColorChoice::always}, {"never", ColorChoice::never}},
         color_, Text::cli_opt_color);
}

CommandLine::Declared& CommandLine::declare(OptionKind kind, std::string_view names, std::string_view shown,
                                            Text meaning) {
  auto& option = options_.emplace_back();
  option.names = names;
  option.kind = kind;
  auto& row = declared_.emplace_back();
  row.shown = shown;
  row.meaning = meaning;
  return row;
}

void CommandLine::argument(std::string_view shown, std::optional<std::string>& target, Text meaning) {
  declare(OptionKind::argument, {}, shown, meaning).take = [&target](Given const& given) {
    target = given.front();
  };
}

void CommandLine::arguments(std::string_view shown, std::vector<std::string>& target, Text meaning) {
  declare(OptionKind::arguments, {}, shown, meaning).take = [&target](Given const& given) { target = given; };
}

void CommandLine::flag(std::string_view names, bool& target, Text meaning) {
  declare(OptionKind::flag, names, {}, meaning).take = [&target](Given const&) { target = true; };
}

void CommandLine::flag_with_word(std::string_view names, std::string_view shown,
                                 std::optional<std::string>& target, Text meaning) {
  declare(OptionKind::flag_with_word, names, shown, meaning).take = [&target](Given const& given) {
    target = given.back();
  };
}

void CommandLine::value(std::string_view names, std::string_view shown, std::optional<std::string>& target,
                        Text meaning) {
  declare(OptionKind::value, names, shown, meaning).take = [&target](Given const& given) {
    target = given.back();
  };
}

void CommandLine::values(std::string_view names, std::string_view shown, std::vector<std::string>& target,
                         Text meaning) {
  declare(OptionKind::value, names, shown, meaning).take = [&target](Given const& given) { target = given; };
}

void CommandLine::choice_of(std::string_view names, std::vector<std::string_view> words,
                            std::function<void(std::size_t)> take, Text meaning) {
  auto& row = declare(OptionKind::value, names, joined(words, "|"), meaning);
  row.take = [name = std::string(names), words = std::move(words),
              take = std::move(take)](Given const& given) {
    auto const found = std::find(words.begin(), words.end(), given.back());
    if (found == words.end()) {
      throw Failure(
          {.text = Text::cli_bad_choice,
           .arguments = {{"option", name}, {"value", given.back()}, {"choices", joined(words, ", ")}}});
    }
    take(static_cast<std::size_t>(found - words.begin()));
  };
}

void CommandLine::refuse(std::string const& word) const {
  auto const unknown = word.substr(0, word.find('='));
  if (unknown.substr(0, 1) != "-") {
    throw Failure(
        {.text = Text::cli_superfluous_argument, .arguments = {{"argument", word}, {"command", command_}}});
  }
  std::vector<std::string_view> known;
  for (auto const& option : options_) {
    auto const names = names_of(option);
    known.insert(known.end(), names.begin(), names.end());
  }
  auto const meant = closest(unknown, known);
  throw Failure({.text = meant.empty() ? Text::cli_unknown_option : Text::cli_unknown_option_meant,
                 .arguments = {{"option", unknown}, {"command", command_}, {"meant", std::string(meant)}}});
}

std::vector<std::string> CommandLine::take_apart_or_refuse(std::span<std::string const> arguments) {
  try {
    return take_apart(arguments, options_);
  } catch (WrongValue const& wrong) {
    bool const takes_none = wrong.option->kind == OptionKind::flag;
    throw Failure({.text = takes_none ? Text::cli_option_without_value : Text::cli_option_value_missing,
                   .arguments = {{"option", std::string(full_name(*wrong.option))}, {"command", command_}}});
  }
}

std::optional<std::string> CommandLine::read(std::span<std::string const> arguments) {
  auto const left_over = take_apart_or_refuse(arguments);
  auto const take = [this](std::size_t i) {
    if (!options_[i].given.empty()) declared_[i].take(options_[i].given);
  };
  // What asks for help is told nothing else.
  take(help_option);
  take(version_option);
  if (wants_help_) return help();
  if (wants_version_) return version_text();
  if (!left_over.empty()) refuse(left_over.front());
  for (std::size_t i = 0; i < options_.size(); ++i) take(i);
  return std::nullopt;
}

std::string help_row(std::string_view name, std::string_view meaning) {
  std::string text = "  " + std::string(name);
  std::size_t column = 2 + display_width(name);
  auto const indent = [&] {
    text.append(meaning_column - column, ' ');
    column = meaning_column;
  };
  if (column + 2 > meaning_column) {
    text += '\n';
    column = 0;
  }
  indent();
  bool first = true;
  for (std::string_view rest = meaning; !rest.empty();) {
    auto const word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    if (!first && column + 1 + display_width(word) > line_width) {
      text += '\n';
      column = 0;
      indent();
    } else if (!first) {
      text += ' ';
      ++column;
    }
    text += word;
    column += display_width(word);
    first = false;
  }
  return text + '\n';
}

std::string CommandLine::help() const {
  auto const say = [this](Text text) { return render({.text = text, .arguments = {}}, language_); };
  std::string usage =
      say(Text::cli_help_usage) + ": axisc " + command_ + " [" + say(Text::cli_help_options) + "]";
  std::string rows;
  std::string options;
  for (std::size_t i = 0; i < options_.size(); ++i) {
    auto const& row = declared_[i];
    if (options_[i].names.empty()) {
      usage += " " + row.shown;
      rows += help_row(row.shown, say(row.meaning));
      continue;
    }
    std::string name = options_[i].names;
    if (auto const comma = name.find(','); comma != std::string::npos) name.insert(comma + 1, " ");
    if (!row.shown.empty()) name += (row.shown.front() == '[' ? "" : " ") + row.shown;
    options += help_row(name, say(row.meaning));
  }
  return say(purpose_) + "\n\n" + usage + "\n\n" + rows + "\n" + say(Text::cli_help_options_heading) + ":\n" +
         options + "\n" + say(examples_) + "\n";
}

std::string version_text() {
  std::string text = "axisc " AXISC_VERSION " (image format ";
  text += std::to_string(axim_major) + "." + std::to_string(axim_minor);
  text += ", runtime interface " + std::to_string(AXISRT_ABI_VERSION);
  return text + ")\n";
}

std::vector<std::string> split_list(std::string_view text) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    auto const comma = std::min(text.find(','), text.size());
    auto part = text.substr(0, comma);
    text.remove_prefix(std::min(comma + 1, text.size()));
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
    if (!part.empty()) parts.emplace_back(part);
  }
  return parts;
}

}  // namespace axisc::cli
