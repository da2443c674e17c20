#include "axisc/answers/simulation/plant_answer.hpp"
#include "axisc/answers/simulation/program_answer.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/files/output_file.hpp"
#include "axisc/files/protected_files.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/printed_errors.hpp"
#include "cli/terminal/progress.hpp"

namespace axisc::cli::says {

constexpr Sentence option_program{"the NC program, or - for standard input",
                                  "das NC-Programm, oder - für die Standardeingabe"};
constexpr Sentence option_simulated_cycles{"also write every NC cycle to this CSV file",
                                           "zusätzlich jeden NC-Zyklus in diese CSV-Datei schreiben"};
constexpr Sentence option_constant_velocity{
    "keep the feed rate everywhere: no ramps, no slower corners, no AX_DEV",
    "überall mit dem Vorschub fahren: keine Rampen, keine langsameren Ecken, kein AX_DEV"};
constexpr Sentence option_sharp_corners{
    "follow corners as they are where the control rounds them (G61, G261, #CONTOUR MODE ON)",
    "Ecken folgen, wie sie sind, wo die Steuerung sie verschleift (G61, G261, #CONTOUR MODE ON)"};
constexpr Sentence option_max_cycles{
    "most NC cycles that are simulated (default: 100000000, or 10000000 where every cycle is written)",
    "höchste Zahl simulierter NC-Zyklen (Standardwert: 100000000, "
    "oder 10000000, wo jeder Zyklus geschrieben wird)"};
constexpr Sentence option_progress{
    "show progress even where standard error is not a terminal",
    "Fortschritt auch zeigen, wenn die Standardfehlerausgabe kein Terminal ist"};
constexpr Sentence option_no_progress{"show no progress", "keinen Fortschritt zeigen"};
constexpr Sentence option_plant_of_axes{
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
  presentation::Format format = presentation::Format::text;
  bool alone = false;
  bool constant_velocity = false;
  bool sharp_corners = false;
  bool progress = false;
  bool no_progress = false;
};

void declare(CommandLine& command_line, SimulateOptions& options) {
  command_line.argument("MACHINE", options.machine, says::argument_input);
  command_line.value("--program", "PART.nc", options.program, says::option_program);
  command_line.value("-o,--output", "FILE.csv", options.output, says::option_simulated_cycles);
  command_line.value("--group", "NAME", options.group, says::option_group);
  command_line.flag("--constant-velocity", options.constant_velocity, says::option_constant_velocity);
  command_line.flag("--sharp-corners", options.sharp_corners, says::option_sharp_corners);
  command_line.value("--max-cycles", "N", options.most_cycles, says::option_max_cycles);
  command_line.value("--plant", "PLANT.json", options.plant, says::option_plant_of_axes);
  command_line.value("--move", "AXIS:MM[:MM_PER_MIN]", options.move, says::option_move);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.alone);
  declare_format(command_line, options.format);
  command_line.flag("--progress", options.progress, says::option_progress);
  command_line.flag("--no-progress", options.no_progress, says::option_no_progress);
}

/// Where every cycle is written, the file must not fill the disk unnoticed: a row has some hundred bytes.
std::uint64_t most_cycles(SimulateOptions const& options) {
  constexpr std::uint64_t most_rows = 10'000'000;
  if (!options.most_cycles) {
    bool const writes_rows = options.output || options.format == presentation::Format::csv;
    return writes_rows ? most_rows : motion::SimulationLimits{}.most_cycles;
  }
  return positive_count("--max-cycles", *options.most_cycles);
}

/// Where every cycle is written, if anywhere.
std::optional<OutputFile> output_file(SimulateOptions const& options, std::string const& input,
                                      std::vector<std::string> sources) {
  if (!options.output) return std::nullopt;
  sources.push_back(input);
  refuse_overwriting({*options.output}, sources);
  return std::optional<OutputFile>(std::in_place, *options.output);
}

ExitStatus simulate_plant(SimulateOptions const& options, CheckedMachine const& checked,
                          Invocation const& invocation, CommandLine const& command_line) {
  auto const run = run_plant(
      {.machine_path = *options.machine, .plant_path = *options.plant, .move = *options.move}, checked, true);
  if (auto file = output_file(options, *options.plant, checked.files)) {
    file->write(plant_table(run.without, run.with, run.cycle_seconds));
    file->commit();
  }
  if (options.format == presentation::Format::csv) {
    invocation.streams.out.write(plant_table(run.without, run.with, run.cycle_seconds));
  } else {
    print(plant_answer(run.figures), options.format, invocation, command_line);
  }
  return ExitStatus::success;
}

ExitStatus simulate_program(SimulateOptions const& options, CheckedMachine checked,
                            Invocation const& invocation, CommandLine const& command_line) {
  ProgramRequest request{.machine_path = *options.machine,
                         .program_path = *options.program,
                         .constant_velocity = options.constant_velocity,
                         .sharp_corners = options.sharp_corners,
                         .most_cycles = most_cycles(options)};
  auto& machine = checked.machine;
  auto const index =
      chosen_group(machine, options.group ? options.group : checked.group, request.machine_path);
  ProgramLines program(request.program_path);
  bool const color = use_color(command_line.color(), system::Stream::error);
  if (!survey_program(program, request, machine, index, printed_problems(invocation, color))) {
    return ExitStatus::findings;
  }
  SimulatedPath const path{.group = machine.groups[index].name,
                           .axes = channel_of(machine, machine.groups[index]).axes,
                           .cycle_time = machine.cycle_time,
                           .dynamics = machine.groups[index].dynamics};
  auto file = output_file(options, request.program_path, checked.files);
  bool const prints_rows = options.format == presentation::Format::csv;
  CycleWriter printed(path, [&](std::string_view text) { invocation.streams.out.write(text); });
  CycleWriter filed(path, [&](std::string_view text) { file->write(text); });
  std::vector<CycleWriter*> rows;
  if (prints_rows) rows.push_back(&printed);
  if (file) rows.push_back(&filed);
  Progress progress(options.progress || (!options.no_progress && progress_is_seen()), invocation.language);
  request.working = [&progress](double share, double seconds) { progress.show(share, seconds); };
  auto const simulated = simulate_answer(program, request, machine, index, path, rows);
  if (!prints_rows) print(simulated.answer, options.format, invocation, command_line);
  if (file) file->commit();
  for (auto const& pass : simulated.exceeded) {
    invocation.streams.err.write(not_kept(pass, request.program_path).line(invocation.language));
  }
  return simulated.exceeded.empty() ? ExitStatus::success : ExitStatus::findings;
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
    throw Failure({says::what});
  }
  Workspace workspace(overrides_with(options.cycle_time));
  auto checked =
      checked_machine(workspace, {.input = *options.machine, .alone = options.alone},
                      printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!checked) return ExitStatus::findings;
  return closed_loop ? simulate_plant(options, *checked, invocation, command_line)
                     : simulate_program(options, *std::move(checked), invocation, command_line);
}

}  // namespace axisc::cli
