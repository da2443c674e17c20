#include "axisc/asked/quantities.hpp"
#include "axisc/checking/path_machine.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/commands/simulate_plant.hpp"
#include "cli/commands/simulate_program.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/printed_errors.hpp"
#include "cli/terminal/progress.hpp"

namespace axisc::cli::says {

constexpr Sentence option_program{"the NC program, or - for standard input",
                                  "das NC-Programm, oder - für die Standardeingabe"};
constexpr Sentence option_output{"also write every NC cycle to this CSV file",
                                 "zusätzlich jeden NC-Zyklus in diese CSV-Datei schreiben"};
constexpr Sentence option_format{
    "output format: summary as text or json, or every cycle as csv (default: text)",
    "Ausgabeformat: Zusammenfassung als text oder json, oder jeder Zyklus als csv (Standardwert: text)"};
constexpr Sentence option_constant_velocity{
    "keep the feed rate everywhere: no ramps, no slower corners, no AX_DEV",
    "überall mit dem Vorschub fahren: keine Rampen, keine langsameren Ecken, kein AX_DEV"};
constexpr Sentence option_max_cycles{
    "most NC cycles that are simulated (default: 100000000, or 10000000 where every cycle is written)",
    "höchste Zahl simulierter NC-Zyklen (Standardwert: 100000000, "
    "oder 10000000, wo jeder Zyklus geschrieben wird)"};
constexpr Sentence option_progress{
    "show progress even where standard error is not a terminal",
    "Fortschritt auch zeigen, wenn die Standardfehlerausgabe kein Terminal ist"};
constexpr Sentence option_no_progress{"show no progress", "keinen Fortschritt zeigen"};
constexpr Sentence option_plant{
    "drive and mechanics of the axes (JSON): simulate the closed loop",
    "Antrieb und Mechanik der Achsen (JSON): den geschlossenen Regelkreis simulieren"};
constexpr Sentence option_move{"AXIS:MM[:MM_PER_MIN]: there and back with the plant (default: vb_max)",
                               "ACHSE:MM[:MM_JE_MIN]: mit der Strecke hin und zurück (Standardwert: vb_max)"};
constexpr Sentence what{"name either --program, or --plant with --move",
                        "entweder --program angeben oder --plant mit --move"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

struct SimulateOptions {
  std::optional<std::string> machine, program, output, group, cycle_time, plant, move, most_cycles;
  SimulateFormat format = SimulateFormat::text;
  bool alone = false;
  bool constant_velocity = false;
  bool progress = false;
  bool no_progress = false;
};

void declare(CommandLine& command_line, SimulateOptions& options) {
  command_line.argument("MACHINE", options.machine, says::argument_input);
  command_line.value("--program", "PART.nc", options.program, says::option_program);
  command_line.value("-o,--output", "FILE.csv", options.output, says::option_output);
  command_line.value("--group", "NAME", options.group, says::option_group);
  command_line.flag("--constant-velocity", options.constant_velocity, says::option_constant_velocity);
  command_line.value("--max-cycles", "N", options.most_cycles, says::option_max_cycles);
  command_line.value("--plant", "PLANT.json", options.plant, says::option_plant);
  command_line.value("--move", "AXIS:MM[:MM_PER_MIN]", options.move, says::option_move);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.alone);
  command_line.choice(
      "--format",
      {{"text", SimulateFormat::text}, {"csv", SimulateFormat::csv}, {"json", SimulateFormat::json}},
      options.format, says::option_format);
  command_line.flag("--progress", options.progress, says::option_progress);
  command_line.flag("--no-progress", options.no_progress, says::option_no_progress);
}

/// Where every cycle is written, the file must not fill the disk unnoticed: a row has some hundred bytes.
std::uint64_t most_cycles(SimulateOptions const& options) {
  constexpr std::uint64_t most_rows = 10'000'000;
  if (!options.most_cycles) {
    bool const writes_rows = options.output || options.format == SimulateFormat::csv;
    return writes_rows ? most_rows : motion::SimulationLimits{}.most_cycles;
  }
  auto const count = parse_count(*options.most_cycles);
  if (!count || *count == 0) {
    throw Failure({.sentence = says::bad_count,
                   .arguments = {{"option", "--max-cycles"}, {"value", *options.most_cycles}}});
  }
  return *count;
}

}  // namespace

ExitStatus simulate(Invocation const& invocation) {
  SimulateOptions options;
  CommandLine command_line("simulate", invocation.language);
  declare(command_line, options);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.machine.has_value(), "MACHINE");
  bool const closed_loop = options.plant && options.move;
  if (options.program.has_value() == closed_loop || options.plant.has_value() != options.move.has_value()) {
    throw Failure({.sentence = says::what, .arguments = {}});
  }
  bool const color = use_color(command_line.color(), system::Stream::error);
  auto checked = checked_machine(
      {.input = *options.machine, .cycle_time = asked_cycle_time(options.cycle_time), .alone = options.alone},
      printed_errors(invocation, color));
  if (!checked) return ExitStatus::findings;
  if (closed_loop) {
    return simulate_plant(
        {.request = {.machine_path = *options.machine, .plant_path = *options.plant, .move = *options.move},
         .output = options.output,
         .format = options.format},
        *checked, invocation);
  }
  return simulate_program({.request = {.machine_path = *options.machine,
                                       .program_path = *options.program,
                                       .constant_velocity = options.constant_velocity,
                                       .most_cycles = most_cycles(options)},
                           .group = options.group ? options.group : checked->group,
                           .output = options.output,
                           .format = options.format,
                           .show_progress = options.progress || (!options.no_progress && progress_is_seen()),
                           .color = color},
                          *std::move(checked), invocation);
}

}  // namespace axisc::cli
