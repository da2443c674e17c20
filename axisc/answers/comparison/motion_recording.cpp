#include "axisc/answers/comparison/motion_recording.hpp"

#include "analysis/comparison/residual.hpp"
#include "analysis/comparison/turns.hpp"
#include "analysis/motion/program/interpreter.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/checking/path_machine.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace axisc::says {

constexpr Sentence no_moves{"the program moves no axis: there is nothing to compare",
                            "das Programm bewegt keine Achse: Es gibt nichts zu vergleichen"};
constexpr Sentence short_pause{
    "the path stops here for less than {pause} s, so that a recording does not show where the next move "
    "begins; write `G04 F{pause}` or a longer dwell after this block",
    "die Bahn hält hier kürzer als {pause} s, sodass eine Aufzeichnung nicht zeigt, wo die nächste Bewegung "
    "beginnt; nach diesem Satz `G04 F{pause}` oder eine längere Verweilzeit schreiben"};
constexpr Sentence filter_command{
    "#FILTER may change how the path is planned; leave it out of a program that is compared",
    "#FILTER kann ändern, wie die Bahn geplant wird; in einem verglichenen Programm weglassen"};
constexpr Sentence no_such_moves{
    "{recording}: the {programmed} moves of {program} are not among the {recorded} of this recording; record "
    "from the rest before the program to the rest after it, with the override at 100 %, and check --unit and "
    "the columns",
    "{recording}: die {programmed} Bewegungen von {program} fehlen unter den {recorded} dieser Aufzeichnung; "
    "vom Stillstand vor dem Programm bis zum Stillstand danach aufzeichnen, mit Override 100 %, und --unit "
    "und die Spalten prüfen"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// By MoveProblemKind.
constexpr std::array<SentenceRef, 2> problem_sentences{says::short_pause, says::filter_command};

std::vector<comparison::Move> moves_of(ProgramLines& program, ProgramRequest const& request,
                                       machine::Machine const& machine, machine::MachineGroup const& group) {
  auto channel = channel_of(machine, group);
  channel.sharp_corners = request.sharp_corners;
  comparison::ProgramMoves moves(machine.cycle_time);
  motion::ProgramInterpreter interpreter(channel, moves, [](motion::ProgramProblem const&) {});
  program.read([&](std::string_view line, std::uint32_t offset) {
    return interpreter.line(line, offset) && !moves.problem();
  });
  interpreter.finish();
  if (auto const& problem = moves.problem()) {
    auto const pause = format_rounded(comparison::shortest_pause_s, 3);
    throw Failure(request.program_path + ":" + std::to_string(problem->line),
                  {{problem_sentences.at(static_cast<std::size_t>(problem->kind)), {{"pause", pause}}}},
                  std::nullopt);
  }
  if (moves.moves().empty()) {
    throw Failure(request.program_path, {{says::no_moves}}, std::nullopt);
  }
  return moves.moves();
}

}  // namespace

RecordedMotion compare_program(ProgramLines& program, ProgramRequest const& request,
                               machine::Machine const& machine, std::size_t index,
                               MotionRecording const& recording) {
  auto const& group = machine.groups[index];
  auto const moves = moves_of(program, request, machine, group);
  auto const file = open_recording(recording.path);
  bool const in_machine = machine.axes.size() > 1 || names_machine(request.machine_path);
  auto columns = read_recorded_positions(file, machine, index, in_machine, recording.columns);
  auto& recorded = columns.recorded;
  auto const image = image_of(machine, request.machine_path);
  RecordedMotion found{.program = request.program_path,
                       .recording = recording.path,
                       .axes = {},
                       .mapping = {},
                       .cycles = recorded.signals.front().size(),
                       .lost = recorded.gaps.size(),
                       .repeated = recorded.repeated,
                       .is_rotary = true,
                       .in_force = machine.motion,
                       .result = {}};
  comparison::RecordedPath path;
  for (std::size_t i = 0; i < columns.axes.size(); ++i) {
    auto const axis = group.axes[columns.axes[i]];
    auto const& listed = image.contents.axes[axis];
    auto& signal = recorded.signals[i];
    auto const scale = column_scale(file, columns.columns[i], recording.units, listed, signal, recorded.gaps);
    double const thousandths = scale.thousandths;
    signal = positions(std::move(signal), scale, thousandths);
    if (auto const range = modulo_range(listed)) {
      found.jumps += comparison::unwind(signal, recorded.gaps, *range / thousandths);
    }
    double const units = thousandths * motion::units_per_um;
    double const resolution = comparison::resolution(signal, recorded.gaps) * units;
    auto values = signal.values();
    for (double& value : values) value *= units;
    path.positions.push_back(comparison::recorded_position(columns.axes[i], std::move(values), resolution));
    found.axes.push_back(machine.axes[axis].name);
    bool const is_rotary = machine.axes[axis].type != machine::AxisType::translatory;
    found.mapping.push_back(mapped_column(file, columns.columns[i], scale, is_rotary));
    found.is_rotary = found.is_rotary && is_rotary;
    found.allowed = std::max(found.allowed, path.positions.back().allowed);
  }
  if (!recorded.gaps.empty()) path.is_gap.assign(found.cycles, 0);
  for (auto const gap : recorded.gaps) path.is_gap[gap] = 1;
  auto compared = comparison::compare_motion(moves, path_dynamics(machine, group), path);
  if (auto const* const missing = std::get_if<comparison::NoSuchMoves>(&compared)) {
    throw Failure({says::no_such_moves,
                   {{"recording", recording.path},
                    {"program", request.program_path},
                    {"programmed", std::to_string(missing->programmed)},
                    {"recorded", std::to_string(missing->recorded)}}});
  }
  found.result = std::get<comparison::MotionComparison>(std::move(compared));
  return found;
}

}  // namespace axisc
