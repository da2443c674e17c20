#include "cli/commands/command_table.hpp"

#include "cli/options/sentences.hpp"
#include "help_folders.hpp"

#include <algorithm>
#include <array>

namespace axisc::cli::says {

constexpr Sentence program_meaning{"check, compile and execute axis parameter lists",
                                   "Achsparameterlisten prüfen, kompilieren und ausführen"};
constexpr Sentence lint_meaning{"check lists and machine files", "Listen und Maschinendateien prüfen"};
constexpr Sentence fmt_meaning{"align the values and comments of lists",
                               "Werte und Kommentare von Listen ausrichten"};
constexpr Sentence compile_meaning{"check, then write a coefficient image",
                                   "prüfen, dann ein Koeffizientenabbild schreiben"};
constexpr Sentence inspect_meaning{"show what is in an image", "zeigen, was in einem Abbild steht"};
constexpr Sentence certify_meaning{"check and print the proved bounds of an image",
                                   "die bewiesenen Schranken eines Abbilds prüfen und ausgeben"};
constexpr Sentence run_meaning{"feed setpoints through an image", "Sollwerte durch ein Abbild führen"};
constexpr Sentence response_meaning{"frequency response of an image", "Frequenzgang eines Abbilds"};
constexpr Sentence plot_meaning{"draw what the filters do", "zeichnen, was die Filter tun"};
constexpr Sentence report_meaning{"write a page about a machine", "eine Seite über eine Maschine schreiben"};
constexpr Sentence export_meaning{"make an FMU or sources in C of a machine's filters",
                                  "aus den Filtern einer Maschine eine FMU oder Quelltexte in C machen"};
constexpr Sentence keygen_meaning{"make a pair of keys for signatures",
                                  "ein Schlüsselpaar für Signaturen erzeugen"};
constexpr Sentence sign_meaning{"sign an image", "ein Abbild signieren"};
constexpr Sentence explain_meaning{"look up a code, a message, a parameter or a word",
                                   "einen Code, eine Meldung, einen Parameter oder ein Wort nachschlagen"};
constexpr Sentence get_meaning{"show which value is in force, and where it comes from",
                               "zeigen, welcher Wert wirkt und woher er kommt"};
constexpr Sentence set_meaning{"write a value into a list", "einen Wert in eine Liste schreiben"};

constexpr Sentence diff_meaning{
    "say what changed between two lists, machines or images",
    "sagen, was sich zwischen zwei Listen, Maschinen oder Abbildern geändert hat"};

constexpr Sentence machine_meaning{
    "show the machine that a start-up list or a machine file describes",
    "die Maschine zeigen, die eine Hochlaufliste oder Maschinendatei beschreibt"};
constexpr Sentence contour_meaning{"predict axis errors and contour deviations",
                                   "Achsfehler und Bahnabweichungen vorhersagen"};
constexpr Sentence circle_meaning{"predict the circular test, and evaluate a recorded one",
                                  "den Kreisformtest vorhersagen und einen aufgezeichneten auswerten"};
constexpr Sentence simulate_meaning{
    "follow an NC program through the filters, or an axis through its control loop",
    "ein NC-Programm durch die Filter verfolgen oder eine Achse durch ihren Regelkreis"};

constexpr Sentence suggest_meaning{"suggest filters for an axis that vibrates",
                                   "Filter für eine Achse vorschlagen, die schwingt"};

constexpr Sentence identify_meaning{"find mass and friction of an axis in recordings of its motion",
                                    "Masse und Reibung einer Achse in Aufzeichnungen ihrer Bewegung finden"};

constexpr Sentence compare_meaning{"compare a control's recording with what axisc computes",
                                   "die Aufzeichnung einer Steuerung mit der Rechnung vergleichen"};
constexpr Sentence replay_meaning{"execute a controller's recording again",
                                  "die Aufzeichnung einer Steuerung noch einmal ausführen"};

constexpr Sentence lsp_meaning{"language server for editors", "Language-Server für Editoren"};

constexpr Sentence schema_meaning{"print the JSON schema of a kind of file",
                                  "das JSON-Schema einer Dateiart ausgeben"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr std::array rows = {CommandRow{"lint", says::lint_meaning, lint},
                             CommandRow{"fmt", says::fmt_meaning, fmt},
                             CommandRow{"compile", says::compile_meaning, compile},
                             CommandRow{"machine", says::machine_meaning, machine},
                             CommandRow{"get", says::get_meaning, get},
                             CommandRow{"set", says::set_meaning, set},
                             CommandRow{"inspect", says::inspect_meaning, inspect},
                             CommandRow{"certify", says::certify_meaning, certify},
                             CommandRow{"run", says::run_meaning, run},
                             CommandRow{"response", says::response_meaning, response},
                             CommandRow{"plot", says::plot_meaning, plot},
                             CommandRow{"report", says::report_meaning, report},
                             CommandRow{"contour", says::contour_meaning, contour},
                             CommandRow{"circle", says::circle_meaning, circle},
                             CommandRow{"simulate", says::simulate_meaning, simulate},
                             CommandRow{"suggest", says::suggest_meaning, suggest},
                             CommandRow{"identify", says::identify_meaning, identify},
                             CommandRow{"compare", says::compare_meaning, compare},
                             CommandRow{"replay", says::replay_meaning, replay},
                             CommandRow{"diff", says::diff_meaning, diff},
                             CommandRow{"export", says::export_meaning, export_filters},
                             CommandRow{"keygen", says::keygen_meaning, keygen},
                             CommandRow{"sign", says::sign_meaning, sign},
                             CommandRow{"explain", says::explain_meaning, explain},
                             CommandRow{"schema", says::schema_meaning, schema},
                             CommandRow{"lsp", says::lsp_meaning, lsp}};

constexpr bool has_help(std::string_view command) {
  return std::find(help_folders.begin(), help_folders.end(), command) != help_folders.end();
}
static_assert(has_help("axisc") && std::all_of(rows.begin(), rows.end(),
                                               [](CommandRow const& row) { return has_help(row.name); }),
              "each command has a folder in cli/help, the program has cli/help/axisc");
static_assert(help_folders.size() == rows.size() + 1, "each folder in cli/help is that of a command");

}  // namespace

std::span<CommandRow const> commands() {
  return rows;
}

CommandDescription program_description() {
  return {.meaning = says::program_meaning,
          .options = {
              {.names = "-h,--help", .meaning = says::option_help},
              {.names = "-V,--version", .meaning = says::option_version},
              {.names = "--lang", .shown = "en|de", .meaning = says::option_lang, .values = {"en", "de"}}}};
}

CommandDescription description_of(CommandRow const& command) {
  CommandDescription description;
  Streams streams;
  static_cast<void>(command.run(
      {.arguments = {}, .language = Language::english, .streams = streams, .description = &description}));
  description.meaning = command.meaning;
  return description;
}

}  // namespace axisc::cli
