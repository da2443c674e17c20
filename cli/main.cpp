#include "cli/codes.hpp"
#include "cli/commands/commands.hpp"
#include "cli/failure.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/help_text.hpp"
#include "cli/sentences.hpp"
#include "configuration/files.hpp"
#include "schema/closest_word.hpp"
#include "system/process.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc::cli::says {

constexpr Sentence changed{
    "cannot read {file}: it changed while it was read; run the command again when no program is writing to "
    "it",
    "{file} ist nicht lesbar: sie wurde beim Lesen geändert; den Befehl wiederholen, wenn kein Programm mehr "
    "in sie schreibt"};

constexpr Sentence no_option{"there is no option {option}; `axisc --help` lists the commands",
                             "die Option {option} gibt es nicht; `axisc --help` listet die Befehle auf"};
constexpr Sentence unknown_command{
    "there is no command \"{command}\"; `axisc --help` lists them",
    "den Befehl \"{command}\" gibt es nicht; `axisc --help` listet die Befehle auf"};
constexpr Sentence unknown_command_meant{R"(there is no command "{command}"; did you mean "{meant}"?)",
                                         R"(den Befehl "{command}" gibt es nicht; war "{meant}" gemeint?)"};
constexpr Sentence no_memory{
    "out of memory; close other programs or check fewer files at once",
    "kein Arbeitsspeicher mehr; andere Programme schließen oder weniger Dateien auf einmal prüfen"};
constexpr Sentence help_command{"COMMAND", "BEFEHL"};
constexpr Sentence help_commands_heading{"Commands", "Befehle"};
constexpr Sentence purpose{
    R"(axisc checks axis parameter lists of CNC controls, compiles the filters they configure into a coefficient
image, and executes such images.)",
    R"(axisc prüft Achsparameterlisten von CNC-Steuerungen, übersetzt die darin konfigurierten Filter in ein
Koeffizientenabbild und führt solche Abbilder aus.)"};
constexpr Sentence lint_meaning{"check lists and machine files", "Listen und Maschinendateien prüfen"};
constexpr Sentence fmt_meaning{"align the values and comments of lists",
                               "Werte und Kommentare von Listen ausrichten"};
constexpr Sentence compile_meaning{"check, then write a coefficient image",
                                   "prüfen, dann ein Koeffizientenabbild schreiben"};
constexpr Sentence inspect_meaning{"show what is in an image", "zeigen, was in einem Abbild steht"};
constexpr Sentence run_meaning{"feed setpoints through an image", "Sollwerte durch ein Abbild führen"};
constexpr Sentence response_meaning{"frequency response of an image", "Frequenzgang eines Abbilds"};
constexpr Sentence plot_meaning{"draw what the filters do", "zeichnen, was die Filter tun"};
constexpr Sentence report_meaning{"write a page about a machine", "eine Seite über eine Maschine schreiben"};
constexpr Sentence keygen_meaning{"make a pair of keys for signatures",
                                  "ein Schlüsselpaar für Signaturen erzeugen"};
constexpr Sentence sign_meaning{"sign an image", "ein Abbild signieren"};
constexpr Sentence explain_meaning{"explain a code or a parameter",
                                   "einen Code oder einen Parameter erklären"};
constexpr Sentence examples{R"(Examples:
  axisc lint machine.json
  axisc compile machine.json -o mill.axim
  axisc run mill.axim --signal step --cycles 100

Each command has its own help: axisc lint --help
Exit status: 0 nothing wrong, 1 findings of severity error, 2 the command line, a file or the environment
is at fault.)",
                            R"(Beispiele:
  axisc lint maschine.json
  axisc compile maschine.json -o fraese.axim
  axisc run fraese.axim --signal step --cycles 100

Jeder Befehl hat seine eigene Hilfe: axisc lint --help
Rückgabewert: 0 alles in Ordnung, 1 Befunde mit Schweregrad Fehler, 2 Befehlszeile, Datei oder
Umgebung sind fehlerhaft.)"};

constexpr Sentence diff_meaning{
    "say what changed between two lists, machines or images",
    "sagen, was sich zwischen zwei Listen, Maschinen oder Abbildern geändert hat"};

constexpr Sentence machine_meaning{
    "show the machine that a start-up list or a machine file describes",
    "die Maschine zeigen, die eine Hochlaufliste oder Maschinendatei beschreibt"};
constexpr Sentence contour_meaning{"predict axis errors and contour deviations",
                                   "Achsfehler und Bahnabweichungen vorhersagen"};
constexpr Sentence simulate_meaning{
    "follow an NC program through the filters, or an axis through its control loop",
    "ein NC-Programm durch die Filter verfolgen oder eine Achse durch ihren Regelkreis"};

constexpr Sentence replay_meaning{"execute a controller's recording again",
                                  "die Aufzeichnung einer Steuerung noch einmal ausführen"};

constexpr Sentence lsp_meaning{"language server for editors", "Language-Server für Editoren"};

constexpr Sentence merge_meaning{"combine the results of shards", "die Ergebnisse von Teilen zusammenführen"};

}  // namespace axisc::cli::says

namespace {

using namespace axisc;
using namespace axisc::cli;

struct Command {
  std::string_view name;
  SentenceRef meaning;
  ExitStatus (*run)(Invocation const&);
};

constexpr std::array<Command, 18> commands = {{{"lint", cli::says::lint_meaning, lint},
                                               {"fmt", cli::says::fmt_meaning, fmt},
                                               {"compile", cli::says::compile_meaning, compile},
                                               {"machine", cli::says::machine_meaning, cli::machine},
                                               {"inspect", cli::says::inspect_meaning, inspect},
                                               {"run", cli::says::run_meaning, run},
                                               {"response", cli::says::response_meaning, response},
                                               {"plot", cli::says::plot_meaning, plot},
                                               {"report", cli::says::report_meaning, report},
                                               {"contour", cli::says::contour_meaning, contour},
                                               {"simulate", cli::says::simulate_meaning, simulate},
                                               {"replay", cli::says::replay_meaning, replay},
                                               {"diff", cli::says::diff_meaning, diff},
                                               {"merge", cli::says::merge_meaning, merge},
                                               {"keygen", cli::says::keygen_meaning, keygen},
                                               {"sign", cli::says::sign_meaning, sign},
                                               {"explain", cli::says::explain_meaning, explain},
                                               {"lsp", cli::says::lsp_meaning, lsp}}};

std::string help(Language language) {
  auto const say = [language](SentenceRef text) {
    return render({.sentence = text, .arguments = {}}, language);
  };
  auto const width = help_width();
  std::string text = help_paragraphs(say(cli::says::purpose), width) + "\n" + say(cli::says::help_usage) +
                     ": axisc " + say(cli::says::help_command) + " [" + say(cli::says::help_options) +
                     "]\n\n" + say(cli::says::help_commands_heading) + ":\n";
  for (auto const& command : commands) text += help_row(command.name, say(command.meaning), width);
  return text + "\n" + say(cli::says::help_options_heading) + ":\n" +
         help_row("-h, --help", say(cli::says::option_help), width) +
         help_row("-V, --version", say(cli::says::option_version), width) +
         help_row("--lang en|de", say(cli::says::option_lang), width) + "\n" +
         help_paragraphs(say(cli::says::examples), width);
}

/// Options that every command has, with a value.
bool takes_value(std::string_view argument) {
  return argument == "--lang" || argument == "--color";
}

/// Index of the command: the first argument that is not an option (nor the value of one that every command has).
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
      throw Failure({.sentence = cli::says::no_option, .arguments = {{"option", argument}}});
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
  for (auto const& command : commands) {
    if (command.name == word) {
      return command.run({.arguments = arguments, .language = language, .streams = streams});
    }
    names.push_back(command.name);
  }
  auto const meant = schema::closest_word(word, names);
  throw Failure({.sentence = meant.empty() ? cli::says::unknown_command : cli::says::unknown_command_meant,
                 .arguments = {{"command", word}, {"meant", std::string(meant)}}});
}

/// The current exception as one line.
std::string failure_line(Language language) {
  try {
    throw;
  } catch (Failure const& failure) {
    return failure.line(language);
  } catch (configuration::SourceChanged const& changed) {
    return Failure({.sentence = cli::says::changed, .arguments = {{"file", changed.path()}}}, cannot_read)
        .line(language);
  } catch (std::bad_alloc const&) {
    return Failure({.sentence = cli::says::no_memory, .arguments = {}}).line(language);
  } catch (std::exception const& error) {
    return Failure({.sentence = cli::says::unexpected, .arguments = {{"reason", error.what()}}})
        .line(language);
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
  } catch (ReaderGone const&) {
    return static_cast<int>(ExitStatus::failure);
  } catch (...) {
    static_cast<void>(system::write(system::Stream::error, failure_line(language)));
    return static_cast<int>(ExitStatus::failure);
  }
}
