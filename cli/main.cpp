#include "cli/codes.hpp"
#include "cli/options/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/failure.hpp"
#include "schema/closest_word.hpp"
#include "configuration/files.hpp"
#include "system/process.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace axisc;
using namespace axisc::cli;

struct Command {
  std::string_view name;
  Text meaning;
  ExitStatus (*run)(Invocation const&);
};

constexpr std::array<Command, 14> commands = {{{"lint", Text::cli_lint_meaning, lint},
                                               {"fmt", Text::cli_fmt_meaning, fmt},
                                               {"compile", Text::cli_compile_meaning, compile},
                                               {"inspect", Text::cli_inspect_meaning, inspect},
                                               {"run", Text::cli_run_meaning, run},
                                               {"response", Text::cli_response_meaning, response},
                                               {"contour", Text::cli_contour_meaning, contour},
                                               {"simulate", Text::cli_simulate_meaning, simulate},
                                               {"replay", Text::cli_replay_meaning, replay},
                                               {"diff", Text::cli_diff_meaning, diff},
                                               {"merge", Text::cli_merge_meaning, merge},
                                               {"keygen", Text::cli_keygen_meaning, keygen},
                                               {"sign", Text::cli_sign_meaning, sign},
                                               {"explain", Text::cli_explain_meaning, explain}}};

std::string help(Language language) {
  auto const say = [language](Text text) { return render({.text = text, .arguments = {}}, language); };
  std::string text = say(Text::cli_purpose) + "\n\n" + say(Text::cli_help_usage) + ": axisc " +
                     say(Text::cli_help_command) + " [" + say(Text::cli_help_options) + "]\n\n" +
                     say(Text::cli_help_commands_heading) + ":\n";
  for (auto const& command : commands) text += help_row(command.name, say(command.meaning));
  return text + "\n" + say(Text::cli_help_options_heading) + ":\n" +
         help_row("-h, --help", say(Text::cli_opt_help)) + help_row("--version", say(Text::cli_opt_version)) +
         help_row("--lang en|de", say(Text::cli_opt_lang)) + "\n" + say(Text::cli_examples) + "\n";
}

/// Index of the command word: the first word that is no option (nor the value of one that every command knows).
std::size_t find_command(std::vector<std::string> const& arguments) {
  std::size_t i = 0;
  while (i < arguments.size() && arguments[i].substr(0, 1) == "-") {
    i += arguments[i] == "--lang" || arguments[i] == "--color" ? 2 : 1;
  }
  return std::min(i, arguments.size());
}

ExitStatus without_command(std::vector<std::string> const& arguments, Language language, Streams& streams) {
  for (auto const& argument : arguments) {
    if (argument == "--help" || argument == "-h") {
      streams.out.write(help(language));
      return ExitStatus::success;
    }
    if (argument == "--version") {
      streams.out.write(version_text());
      return ExitStatus::success;
    }
  }
  throw Failure({.text = Text::cli_no_command, .arguments = {}});
}

ExitStatus dispatch(std::vector<std::string> arguments, Language language, Streams& streams) {
  auto const at = find_command(arguments);
  if (at == arguments.size()) return without_command(arguments, language, streams);
  auto const word = arguments[at];
  arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(at));
  std::vector<std::string_view> names;
  for (auto const& command : commands) {
    if (command.name == word) {
      return command.run({.arguments = arguments, .language = language, .streams = streams});
    }
    names.push_back(command.name);
  }
  auto const meant = schema::closest_word(word, names);
  throw Failure({.text = meant.empty() ? Text::cli_unknown_command : Text::cli_unknown_command_meant,
                 .arguments = {{"command", word}, {"meant", std::string(meant)}}});
}

/// The exception that is being handled, as one line.
std::string failure_line(Language language) {
  try {
    throw;
  } catch (Failure const& failure) {
    return failure.line(language);
  } catch (configuration::SourceChanged const& changed) {
    return Failure({.text = Text::ax9001_changed, .arguments = {{"file", changed.path()}}}, cannot_read)
        .line(language);
  } catch (std::bad_alloc const&) {
    return Failure({.text = Text::cli_no_memory, .arguments = {}}).line(language);
  } catch (std::exception const& error) {
    return Failure({.text = Text::cli_unexpected, .arguments = {{"reason", error.what()}}}).line(language);
  }
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
  } catch (...) {
    static_cast<void>(system::write(system::Stream::error, failure_line(language)));
    return static_cast<int>(ExitStatus::failure);
  }
}
