#include "axisc/answers/simulation/followed_program.hpp"

#include "analysis/motion/program/interpreter.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/sentences.hpp"
#include "configuration/machine/guards.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <utility>

namespace axisc::says {

constexpr Sentence simulation_bank{"the image has no kernels for `{command}`",
                                   "das Abbild hat keine Kerne für `{command}`"};

constexpr Sentence too_many_cycles{
    "here the program exceeds {cycles} NC cycles ({time} s), the most that are simulated; check the feed "
    "rates and dwells, or allow more with --max-cycles",
    "hier überschreitet das Programm {cycles} NC-Zyklen ({time} s), mehr werden nicht simuliert; Vorschübe "
    "und Verweilzeiten prüfen oder mit --max-cycles mehr erlauben"};

constexpr Sentence tolerance_exceeded{
    "AX_DEV is not kept in this pass: axis error {error} µm, tolerance {tolerance} µm",
    "AX_DEV wird in diesem Durchgang nicht eingehalten: Achsfehler {error} µm, Toleranz {tolerance} µm"};

constexpr Sentence not_computed{
    "the simulation leaves `{parameter}` ({number}) out: times and velocities are those without it",
    "die Simulation berücksichtigt `{parameter}` ({number}) nicht: Zeiten und Geschwindigkeiten gelten ohne "
    "diesen Parameter"};

constexpr Sentence not_simulated_first{"only its first occurrence is named",
                                       "nur das erste Vorkommen wird genannt"};

constexpr Sentence cannot_simulate_help{"docs/nc-programs.md says what is supported",
                                        "docs/nc-programs.md sagt, was unterstützt wird"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr Code not_simulated_code{9007};

/// Records which kernels the program needs.
class CommandCollector final : public motion::PathListener {
 public:
  void motion(motion::ProgrammedBlock const& /*block*/) override {}
  void command(motion::FilterChange const& change) override {
    current_ = machine::parameters_after(current_, change.command);
    if (current_.empty() || std::find(sets.begin(), sets.end(), current_) != sets.end()) return;
    sets.push_back(current_);
  }
  void end() override {}

  std::vector<machine::FilterParameters> sets;

 private:
  machine::FilterParameters current_;
};

/// A program is never held completely: a source holds only the line in question, with its line number.
void pass_on(motion::ProgramProblem problem, std::string const& path, TakeProblem const& take) {
  std::string padded(problem.line - 1, '\n');
  auto const begin = static_cast<std::uint32_t>(padded.size());
  SourceSet sources;
  auto const source = sources.add(SourceText(path, padded + problem.line_text));
  problem.finding.place =
      Place{.source = source, .span = {.begin = begin + problem.span.begin, .end = begin + problem.span.end}};
  bool const ignored = problem.finding.severity != Severity::error;
  if (ignored || problem.finding.name == "cannot-simulate") {
    SentenceRef const help = ignored ? says::not_simulated_first : says::cannot_simulate_help;
    problem.finding.help.push_back({help});
  }
  take(problem.finding, sources);
}

/// Names what the lists of the group say and no plan takes into account.
void tell_uncomputed(machine::Machine const& machine, machine::MachineGroup const& group,
                     TakeProblem const& take) {
  std::vector<machine::UncomputedParameter> uncomputed = group.uncomputed;
  for (auto const axis : group.axes) {
    auto const& own = machine.axes[axis].uncomputed;
    uncomputed.insert(uncomputed.end(), own.begin(), own.end());
  }
  for (auto const& parameter : uncomputed) {
    SourceSet sources;
    std::string const padded(parameter.line - 1, '\n');
    auto const begin = static_cast<std::uint32_t>(padded.size() + parameter.line_text.find(parameter.name));
    auto const source = sources.add(SourceText(parameter.file, padded + parameter.line_text));
    Finding finding;
    finding.code = not_simulated_code;
    finding.severity = Severity::warning;
    finding.name = "not-simulated";
    finding.message = {says::not_computed, {{"parameter", parameter.name}, {"number", parameter.number}}};
    finding.place =
        Place{.source = source,
              .span = {.begin = begin, .end = begin + static_cast<std::uint32_t>(parameter.name.size())}};
    take(finding, sources);
  }
}

/// Reads the program once without moving anything: reports its mistakes and finds its #FILTER commands.
bool survey(ProgramLines& program, ProgramRequest const& request, motion::ProgramChannel const& channel,
            CommandCollector& collector, TakeProblem const& take) {
  constexpr std::size_t most_errors = 20;
  std::size_t errors = 0;
  motion::ProgramInterpreter interpreter(channel, collector, [&](motion::ProgramProblem problem) {
    if (problem.finding.severity == Severity::error && ++errors > most_errors) return;
    pass_on(std::move(problem), request.program_path, take);
  });
  program.read([&](std::string_view line, std::uint32_t offset) {
    return interpreter.line(line, offset) && errors <= most_errors;
  });
  interpreter.finish();
  return errors == 0;
}

[[noreturn]] void fail(motion::SimulationFailure const& failure, ProgramRequest const& request,
                       machine::Machine const& machine, machine::MachineGroup const& group) {
  if (failure.endless_line) {
    double const seconds = static_cast<double>(request.most_cycles) * machine.cycle_time.seconds();
    throw Failure(request.program_path + ":" + std::to_string(*failure.endless_line),
                  {{says::too_many_cycles,
                    {{"cycles", std::to_string(request.most_cycles)}, {"time", format_rounded(seconds, 4)}}}},
                  std::nullopt);
  }
  if (failure.blocking_axis) {
    throw Failure({says::blocks_constant,
                   {{"axis", machine.axes[group.axes[*failure.blocking_axis]].name}, {"group", group.name}}});
  }
  if (!failure.command.empty()) {
    throw Failure({says::simulation_bank, {{"command", failure.command}}});
  }
  throw Failure(
      {says::runtime,
       {{"status", axisrt_status_name(failure.status)}, {"reason", axisrt_status_text(failure.status)}}});
}

}  // namespace

motion::ProgramChannel channel_of(machine::Machine const& machine, machine::MachineGroup const& group) {
  motion::ProgramChannel channel;
  channel.inch = machine.inch;
  channel.cycle_time = machine.cycle_time;
  channel.read_filter_command = filter_command_reader(machine, group);
  channel.dynamics = group.dynamics;
  for (auto const axis : group.axes) {
    channel.axes.push_back(machine.axes[axis].name);
    channel.rotary.push_back(machine.axes[axis].type != machine::AxisType::translatory);
  }
  return channel;
}

bool survey_program(ProgramLines& program, ProgramRequest const& request, machine::Machine& machine,
                    std::size_t group, TakeProblem const& take) {
  CommandCollector collector;
  auto channel = channel_of(machine, machine.groups[group]);
  channel.sharp_corners = request.sharp_corners;
  tell_uncomputed(machine, machine.groups[group], take);
  if (!survey(program, request, channel, collector, take)) return false;
  auto& sets = machine.groups[group].filter_sets;
  for (auto const& parameters : collector.sets) {
    if (parameters.guard) machine::add_guards(machine, group);
    if (std::find(sets.begin(), sets.end(), parameters) == sets.end()) sets.push_back(parameters);
  }
  return true;
}

FollowedProgram follow_program(ProgramLines& program, ProgramRequest const& request,
                               machine::Machine const& machine, std::size_t index,
                               motion::SimulationListener& listener) {
  auto const& group = machine.groups[index];
  auto channel = channel_of(machine, group);
  channel.sharp_corners = request.sharp_corners;
  auto const image = image_of(machine, request.machine_path);
  double const seconds = machine.cycle_time.seconds();
  double share = 0;
  motion::Simulation const* running = nullptr;
  auto const show_progress = [&] {
    if (running != nullptr && request.working) {
      request.working(share, static_cast<double>(running->cycles()) * seconds);
    }
  };
  motion::Simulation simulation(group_runtime(image, group, request.machine_path, &machine),
                                group_runtime(image, group, request.machine_path, &machine),
                                motion::PathLimits(path_dynamics(machine, group)), request.constant_velocity,
                                listener, {.most_cycles = request.most_cycles, .working = show_progress});
  running = &simulation;
  motion::ProgramInterpreter interpreter(channel, simulation, [](motion::ProgramProblem const&) {});
  program.read([&](std::string_view line, std::uint32_t offset) {
    share = static_cast<double>(offset) / static_cast<double>(program.size());
    if (offset % 64 == 0) show_progress();
    return interpreter.line(line, offset) && !simulation.failure();
  });
  interpreter.finish();
  if (simulation.failure()) fail(*simulation.failure(), request, machine, group);
  return {.blocks = simulation.blocks(), .cycles = simulation.cycles(), .rounding = interpreter.rounding()};
}

Failure not_kept(motion::PassSummary const& pass, std::string const& path) {
  auto const um = [](double units) { return format_rounded(units / motion::units_per_um, 4); };
  return Failure(
      path + ":" + std::to_string(pass.line),
      {{says::tolerance_exceeded,
        {{"error", um(pass.largest_axis_error())}, {"tolerance", um(pass.tolerance.value_or(0))}}}},
      std::nullopt);
}

}  // namespace axisc
