#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/files/compiled_input.hpp"
#include "cli/files/output_file.hpp"
#include "cli/files/protected_files.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/frequencies.hpp"
#include "cli/options/timed_commands.hpp"
#include "cli/plots/plots.hpp"
#include "cli/sentences.hpp"
#include "pictures/svg.hpp"

namespace axisc::cli::says {

constexpr Sentence purpose{
    R"(Draws what `response` and `run` compute: magnitude, phase and group delay over frequency, or the answer to a step
with its velocity and acceleration. Several axes lie over one another; a single one is shown with each of its filters.
The picture is an SVG file, the same bytes on every host.)",
    R"(Zeichnet, was `response` und `run` berechnen: Betrag, Phase und Gruppenlaufzeit über der Frequenz oder die Antwort
auf einen Sprung mit Geschwindigkeit und Beschleunigung. Mehrere Achsen liegen übereinander; eine einzelne zeigt jeden
ihrer Filter. Das Bild ist eine SVG-Datei, auf jedem Rechner dieselben Bytes.)"};
constexpr Sentence examples{R"(Examples:
  axisc plot machine.json --axis X -o x.svg
  axisc plot mill.axim --kind step -o step.svg
  axisc plot listen/ --axis X --mark 48Hz -o x.svg)",
                            R"(Beispiele:
  axisc plot maschine.json --axis X -o x.svg
  axisc plot fraese.axim --kind step -o sprung.svg
  axisc plot listen/ --axis X --mark 48Hz -o x.svg)"};
constexpr Sentence argument_plotted{
    "a list, a machine file, a start-up list, a project, a folder with one machine, or an image",
    "eine Liste, eine Maschinendatei, eine Hochlaufliste, ein Projekt, ein Ordner mit einer Maschine oder "
    "ein Abbild"};
constexpr Sentence option_kind{"what to draw (default: response)",
                               "was zu zeichnen ist (Standardwert: response)"};
constexpr Sentence option_svg{"where the picture goes, FILE.svg or - for standard output",
                              "wohin das Bild geht, DATEI.svg oder - für die Standardausgabe"};
constexpr Sentence option_plotted_axis{"only this axis, with each of its filters (default: all)",
                                       "nur diese Achse, mit jedem ihrer Filter (Standardwert: alle)"};
constexpr Sentence option_mark{"also mark this frequency: 48 or 48Hz",
                               "auch diese Frequenz markieren: 48 oder 48Hz"};
constexpr Sentence option_linear{"linear frequency (default: logarithmic)",
                                 "lineare Frequenz (Standardwert: logarithmisch)"};
constexpr Sentence option_magnitude{"magnitude in dB or as a factor (default: db)",
                                    "Betrag in dB oder als Faktor (Standardwert: db)"};
constexpr Sentence option_wrap{"phase from -180° to 180° (default: continuous)",
                               "Phase von -180° bis 180° (Standardwert: stetig)"};
constexpr Sentence no_output{"where should the picture go? Give -o FILE.svg, or -o - for standard output",
                             "wohin soll das Bild? -o DATEI.svg angeben oder -o - für die Standardausgabe"};
constexpr Sentence of_response{"{option} belongs to --kind response", "{option} gehört zu --kind response"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

enum class Kind : std::uint8_t { response, step };

struct PlotOptions {
  std::optional<std::string> input, axis, output, cycle_time, level;
  std::vector<std::string> marks, commands;
  Kind kind = Kind::response;
  ResponsePlot response;
};

void declare(CommandLine& command_line, PlotOptions& options) {
  command_line.argument("INPUT", options.input, says::argument_plotted);
  command_line.value("-o,--output", "FILE.svg", options.output, says::option_svg);
  command_line.choice("--kind", {{"response", Kind::response}, {"step", Kind::step}}, options.kind,
                      says::option_kind);
  command_line.value("--axis", "NAME", options.axis, says::option_plotted_axis);
  command_line.values("--mark", "HZ", options.marks, says::option_mark);
  command_line.flag("--linear", options.response.linear_frequency, says::option_linear);
  command_line.choice("--magnitude", {{"db", false}, {"linear", true}}, options.response.linear_magnitude,
                      says::option_magnitude);
  command_line.flag("--wrap", options.response.wraps_phase, says::option_wrap);
  command_line.values("--at", "CYCLE:COMMAND", options.commands, says::option_at);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
}

/// "48" or "48Hz".
std::vector<double> frequencies_of(std::vector<std::string> const& marks, design::CycleTime cycle_time) {
  std::vector<double> frequencies;
  for (std::string word : marks) {
    if (word.ends_with("Hz")) word.resize(word.size() - 2);
    auto const read = parse_frequencies(word, cycle_time);
    frequencies.insert(frequencies.end(), read.begin(), read.end());
  }
  return frequencies;
}

void refuse_mixture(PlotOptions const& options) {
  if (options.kind == Kind::response) return;
  for (auto const& [given, option] : {std::pair(!options.marks.empty(), "--mark"),
                                      {options.response.linear_frequency, "--linear"},
                                      {options.response.linear_magnitude, "--magnitude linear"},
                                      {options.response.wraps_phase, "--wrap"}}) {
    if (given) throw Failure({.sentence = says::of_response, .arguments = {{"option", option}}});
  }
}

}  // namespace

ExitStatus plot(Invocation const& invocation) {
  PlotOptions options;
  CommandLine command_line("plot", says::purpose, says::examples, invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.input.has_value(), "INPUT");
  if (!options.output) throw Failure({.sentence = says::no_output, .arguments = {}});
  refuse_mixture(options);
  refuse_overwriting({*options.output}, {*options.input});
  auto const file = compiled_input(*options.input, options.cycle_time, invocation,
                                   use_color(command_line.color(), system::Stream::error));
  if (!file) return ExitStatus::findings;
  auto host = start_runtime(*options.input, *file);
  for (auto const& command :
       read_timed_commands(options.commands, *file, *options.input, invocation.language)) {
    execute(command, host, file->contents, *options.input);
  }
  options.response.marks = frequencies_of(options.marks, file->contents.cycle_time);
  PlotSubject const subject{.file = *file,
                            .host = host,
                            .axes = chosen_axes(file->contents, options.axis),
                            .language = invocation.language};
  auto const figure =
      options.kind == Kind::step ? step_figure(subject) : response_figure(subject, options.response);
  std::string const text = pictures::svg(figure, invocation.language);
  if (*options.output == "-") {
    invocation.streams.out.write(text);
    return ExitStatus::success;
  }
  OutputFile target(*options.output);
  target.write(text);
  target.commit();
  return ExitStatus::success;
}

}  // namespace axisc::cli
