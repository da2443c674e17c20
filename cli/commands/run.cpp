#include "axisc/answers/execution/execution.hpp"
#include "axisc/answers/execution/stimulus.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/files/byte_source.hpp"
#include "axisc/files/image_file.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "axisrt.h"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"

#include <memory>

namespace axisc::cli::says {

constexpr Sentence bad_signal{
    "\"{value}\" is not a signal; choose step, ramp:UNITS_PER_S, sine:HZ or impulse",
    "\"{value}\" ist kein Signal; möglich sind step, ramp:EINHEITEN_JE_S, sine:HZ und impulse"};
constexpr Sentence refused_setpoints{
    "{count} inputs were NaN, infinite or beyond 2^53, the first in cycle {cycle}; the last good one was "
    "used instead",
    "{count} Eingaben waren NaN, unendlich oder größer als 2^53, die erste in Zyklus {cycle}; stattdessen "
    "galt die letzte gute"};
constexpr Sentence refused_setpoint{
    "an input in cycle {cycle} was NaN, infinite or beyond 2^53; the last good one was used instead",
    "eine Eingabe in Zyklus {cycle} war NaN, unendlich oder größer als 2^53; stattdessen galt die letzte "
    "gute"};
constexpr Sentence jump{
    "an output moved farther in cycle {cycle} than the axis' largest velocity (P-AXIS-00212) allows",
    "eine Ausgabe bewegte sich in Zyklus {cycle} weiter, als die größte Geschwindigkeit der Achse "
    "(P-AXIS-00212) zulässt"};
constexpr Sentence jumps{
    "{count} outputs moved farther in one cycle than the axis' largest velocity (P-AXIS-00212) allows, the "
    "first in cycle {cycle}",
    "{count} Ausgaben bewegten sich in einem Zyklus weiter, als die größte Geschwindigkeit der Achse "
    "(P-AXIS-00212) zulässt, die erste in Zyklus {cycle}"};
constexpr Sentence option_input{"setpoints, first line: column names; - is standard input",
                                "Sollwerte, erste Zeile: Spaltennamen; - ist die Standardeingabe"};
constexpr Sentence option_signal{
    "step (default), ramp:UNITS_PER_S, sine:HZ or impulse, instead of a file",
    "step (Standardwert), ramp:EINHEITEN_JE_S, sine:HZ oder impulse, statt einer Datei"};
constexpr Sentence option_amplitude{"factor of the signal (default: 1)",
                                    "Faktor des Signals (Standardwert: 1)"};
constexpr Sentence option_cycles{"length of the signal (default: 256)",
                                 "Länge des Signals (Standardwert: 256)"};
constexpr Sentence option_port_of_signal{"what the signal feeds (default: setpoint)",
                                         "was das Signal speist (Standardwert: setpoint)"};
constexpr Sentence option_reset{"value from which every axis starts, at rest (default: 0)",
                                "Wert, auf dem jede Achse anfangs ruht (Standardwert: 0)"};
constexpr Sentence option_csv_output{"where the rows go (default: standard output)",
                                     "wohin die Zeilen gehen (Standardwert: Standardausgabe)"};
constexpr Sentence option_time{"begin each row with the time in seconds (column time_s)",
                               "jede Zeile mit der Zeit in Sekunden beginnen (Spalte time_s)"};
constexpr Sentence option_format{
    "csv, which reads back as the same numbers, or text: aligned, four significant digits (default: csv)",
    "csv, das dieselben Zahlen ergibt, oder text: ausgerichtet, vier gültige Stellen (Standardwert: csv)"};
constexpr Sentence option_no_setpoint_warning{"no warning about unusable setpoints",
                                              "keine Warnung über unbrauchbare Sollwerte"};

constexpr Sentence option_record{
    "keep the last cycles and write them to this file, for `axisc replay`",
    "die letzten Zyklen behalten und in diese Datei schreiben, für `axisc replay`"};
constexpr Sentence option_record_cycles{"how many cycles --record keeps (default: 1000)",
                                        "wie viele Zyklen --record behält (Standardwert: 1000)"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr std::uint64_t default_cycles = 256;
constexpr std::uint64_t default_record_cycles = 1000;
constexpr std::uint64_t most_record_cycles = 10'000'000;

struct RunOptions {
  std::optional<std::string> image;
  std::optional<std::string> input;
  std::optional<std::string> signal;
  std::optional<std::string> amplitude;
  std::optional<std::string> cycles;
  std::optional<std::string> reset;
  std::optional<std::string> output;
  std::vector<std::string> commands;
  std::optional<std::string> port;
  std::optional<std::string> level;
  std::optional<std::string> record;
  std::optional<std::string> record_cycles;
  bool quiet = false;
  RunTable table;
};

void declare(CommandLine& command_line, RunOptions& options) {
  command_line.argument("IMAGE.axim", options.image, says::argument_image);
  command_line.value("--input", "FILE.csv", options.input, says::option_input);
  command_line.not_with("--input");
  command_line.value("--signal", "SIGNAL", options.signal, says::option_signal);
  command_line.value("--amplitude", "A", options.amplitude, says::option_amplitude);
  command_line.value("--cycles", "N", options.cycles, says::option_cycles);
  command_line.value("--port", "setpoint|interface|velocity", options.port, says::option_port_of_signal);
  command_line.not_with({});
  command_line.value("--reset", "POSITION", options.reset, says::option_reset);
  command_line.values("--at", "CYCLE:COMMAND", options.commands, says::option_at);
  command_line.value("--level", level_names, options.level, says::option_level);
  command_line.value("-o,--output", "FILE.csv", options.output, says::option_csv_output);
  command_line.value("--record", "FILE.axrd", options.record, says::option_record);
  command_line.only_with("--record");
  command_line.value("--record-cycles", "N", options.record_cycles, says::option_record_cycles);
  command_line.only_with({});
  command_line.flag("--time", options.table.has_time, says::option_time);
  command_line.choice("--format", {{"csv", false}, {"text", true}}, options.table.is_text,
                      says::option_format);
  command_line.flag("-q,--quiet", options.quiet, says::option_no_setpoint_warning);
}

double number(std::optional<std::string> const& word, char const* option, double otherwise) {
  if (!word) return otherwise;
  auto const value = parse_number(*word);
  if (!value) {
    throw Failure({says::bad_number, {{"option", option}, {"value", *word}}});
  }
  return *value;
}

/// Length of the signal.
std::uint64_t cycles_of(RunOptions const& options) {
  if (!options.cycles) return default_cycles;
  if (auto const value = parse_count(*options.cycles)) return *value;
  throw Failure({says::bad_count, {{"option", "--cycles"}, {"value", *options.cycles}}});
}

Port port_of(RunOptions const& options) {
  for (auto const& [name, port] : ports) {
    if (!options.port || *options.port == name) return port;
  }
  throw Failure(
      {says::bad_choice,
       {{"option", "--port"}, {"value", *options.port}, {"choices", "setpoint, interface, velocity"}}});
}

void protect_inputs(RunOptions const& options) {
  std::vector<std::string> outputs;
  for (auto const& output : {options.output, options.record}) {
    if (output) outputs.push_back(*output);
  }
  refuse_overwriting(outputs, {*options.image, options.input.value_or("-")});
}

std::unique_ptr<Stimulus> make_stimulus(RunOptions const& options, image::ImageContents const& image) {
  if (options.input) return std::make_unique<CsvStimulus>(image, *options.input, open_source(*options.input));
  auto const text = options.signal.value_or("step");
  auto const signal = Signal::parse(text);
  if (!signal) throw Failure({says::bad_signal, {{"value", text}}});
  auto stimulus = std::make_unique<SignalStimulus>(
      image, SignalStimulus::Facts{.signal = *signal,
                                   .amplitude = number(options.amplitude, "--amplitude", 1),
                                   .cycles = cycles_of(options),
                                   .port = port_of(options)});
  if (stimulus->channels().empty()) {
    SentenceRef const text_of_port =
        port_of(options) == Port::velocity ? says::no_velocities : says::no_interface_filter;
    throw Failure({text_of_port, {{"file", *options.image}}});
  }
  return stimulus;
}

void write_recording(std::string const& path, std::vector<std::byte> const& bytes) {
  OutputFile target(path);
  target.write({reinterpret_cast<char const*>(bytes.data()), bytes.size()});
  target.commit();
}

void report(Occurrences const& occurrences, SentenceRef one, SentenceRef many, Invocation const& invocation) {
  if (occurrences.count == 0) return;
  auto told = counted(occurrences.count, one, many);
  told.arguments.push_back({"cycle", std::to_string(occurrences.first_cycle)});
  invocation.streams.err.write(warning_line(told, invocation.language));
}

}  // namespace

ExitStatus run(Invocation const& invocation) {
  RunOptions options;
  CommandLine command_line("run", invocation.language);
  declare(command_line, options);
  auto& out = invocation.streams.out;
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.image.has_value(), "IMAGE.axim");
  protect_inputs(options);
  auto const port = port_of(options);
  double const position = number(options.reset, "--reset", 0);
  auto const recorded_cycles =
      options.record_cycles ? positive_count("--record-cycles", *options.record_cycles, most_record_cycles)
                            : default_record_cycles;
  auto const file = load_image(*options.image);
  auto const stimulus = make_stimulus(options, file.contents);
  auto commands = read_timed_commands(options.commands, file, *options.image, invocation.language);
  if (!options.input) refuse_late(commands, cycles_of(options));
  Execution execution(*options.image, start_runtime(*options.image, file, level_of(options.level)),
                      file.contents, *stimulus, std::move(commands));
  if (options.record) execution.record(static_cast<std::uint32_t>(recorded_cycles));
  execution.reset(position, port);
  Noticed noticed;
  if (options.output) {
    OutputFile target(*options.output);
    noticed = execution.go(options.table, [&target](std::string_view text) { target.write(text); });
    target.commit();
  } else {
    noticed = execution.go(options.table, [&out](std::string_view text) { out.write(text); });
  }
  if (options.record) write_recording(*options.record, execution.recording());
  if (options.quiet) return ExitStatus::success;
  report(noticed.refused, says::refused_setpoint, says::refused_setpoints, invocation);
  report(noticed.jumps, says::jump, says::jumps, invocation);
  return ExitStatus::success;
}

}  // namespace axisc::cli
