#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/failure_line.hpp"
#include "axisc/environment/version.hpp"
#include "cli/commands/command_table.hpp"
#include "cli/help/help_page.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/help_text.hpp"
#include "cli/options/sentences.hpp"
#include "schema/closest_word.hpp"
#include "system/process.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::cli::says {

constexpr Sentence no_option{"there is no option {option}; `axisc --help` lists the commands",
                             "die Option {option} gibt es nicht; `axisc --help` listet die Befehle auf"};
constexpr Sentence unknown_command{
    "there is no command \"{command}\"; `axisc --help` lists them",
    "den Befehl \"{command}\" gibt es nicht; `axisc --help` listet die Befehle auf"};
constexpr Sentence unknown_command_meant{R"(there is no command "{command}"; did you mean "{meant}"?)",
                                         R"(den Befehl "{command}" gibt es nicht; war "{meant}" gemeint?)"};
constexpr Sentence help_command{"COMMAND", "BEFEHL"};
constexpr Sentence help_commands_heading{"Commands", "Befehle"};

}  // namespace axisc::cli::says

namespace {

using namespace axisc;
using namespace axisc::cli;

std::string help(Language language) {
  auto const say = [language](SentenceRef text) { return render({text}, language); };
  auto const width = help_width();
  auto const page = help_page({}, language);
  std::string text = help_paragraphs(page.purpose, width) + "\n" + say(cli::says::help_usage) + ": axisc " +
                     say(cli::says::help_command) + " [" + say(cli::says::help_options) + "]\n\n" +
                     say(cli::says::help_commands_heading) + ":\n";
  for (auto const& command : commands()) text += help_row(command.name, say(command.meaning), width);
  text += "\n" + say(cli::says::help_options_heading) + ":\n";
  for (auto const& option : program_description().options) {
    text += help_row(heading_of(option, language), say(option.meaning), width);
  }
  return text + "\n" + help_paragraphs(page.examples, width);
}

/// Options that every command has, with a value.
bool takes_value(std::string_view argument) {
  return argument == "--lang" || argument == "--color";
}

/// Index of the command: the first argument that is not an option (nor the value of one that every command
/// has).
std::size_t find_command(std::vector<std::string> const& arguments) {
  std::size_t i = 0;
  while (i < arguments.size() && arguments[i].substr(0, 1) == "-") {
    i += takes_value(arguments[i]) ? 2 : 1;
  }
  return std::min(i, arguments.size());
}

/// Options that need no command; without any the commands are shown as for --help, but something is missing.
ExitStatus without_command(std::vector<std::string> const& arguments, Language language, Streams& streams) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    auto const& argument = arguments[i];
    if (argument == "--help" || argument == "-h") {
      streams.out.write(help(language));
      return ExitStatus::success;
    }
    if (argument == "--version" || argument == "-V") {
      streams.out.write(version_text());
      return ExitStatus::success;
    }
    if (takes_value(argument)) {
      ++i;
    } else if (!argument.starts_with("--lang=") && !argument.starts_with("--color=")) {
      throw Failure({cli::says::no_option, {{"option", argument}}});
    }
  }
  streams.err.write(help(language));
  return ExitStatus::failure;
}

ExitStatus dispatch(std::vector<std::string> arguments, Language language, Streams& streams) {
  auto const at = find_command(arguments);
  if (at == arguments.size()) return without_command(arguments, language, streams);
  auto word = arguments[at];
  arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(at));
  if (word == "version") return without_command({"--version"}, language, streams);
  if (word == "help") {
    if (arguments.size() == at) return without_command({"--help"}, language, streams);
    word = std::exchange(arguments[at], "--help");
  }
  std::vector<std::string_view> names;
  for (auto const& command : commands()) {
    if (command.name == word) {
      return command.run({.arguments = arguments, .language = language, .streams = streams});
    }
    names.push_back(command.name);
  }
  auto const meant = schema::closest_word(word, names);
  throw Failure({meant.empty() ? cli::says::unknown_command : cli::says::unknown_command_meant,
                 {{"command", word}, {"meant", std::string(meant)}}});
}

}  // namespace

int main(int argc, char* argv[]) {
  system::keep_memory();
  system::prepare_streams();
  Streams streams;
  Language language = Language::english;
  try {
    std::vector<std::string> const arguments(argv + std::min(argc, 1), argv + argc);
    language = choose_language(arguments);
    auto const status = dispatch(arguments, language, streams);
    streams.out.flush();
    streams.err.flush();
    return static_cast<int>(status);
  } catch (ReaderGone const&) {
    return static_cast<int>(ExitStatus::failure);
  } catch (...) {
    static_cast<void>(system::write(system::Stream::error, failure_line(language)));
    return static_cast<int>(ExitStatus::failure);
  }
}
