#include "axisc/answers/simulation/plant_run.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/sentences.hpp"
#include "axisc/settings/plant_file.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::says {

constexpr Sentence bad_move{
    "--move needs AXIS:MM or AXIS:MM:MM_PER_MIN with a distance other than 0, not \"{value}\"",
    "--move braucht ACHSE:MM oder ACHSE:MM:MM_JE_MIN mit einem Weg ungleich 0, nicht \"{value}\""};

constexpr Sentence slow_move{
    "--move would take {cycles} NC cycles, and at most {most} are simulated: a higher velocity or a shorter "
    "way is needed",
    "--move würde {cycles} NC-Zyklen dauern, höchstens {most} werden simuliert: nötig ist eine höhere "
    "Geschwindigkeit oder ein kürzerer Weg"};

}  // namespace axisc::says

namespace axisc {

namespace {

struct Move {
  std::string axis;
  double distance_mm = 0;
  std::optional<double> feed_mm_per_min;
};

/// AXIS:MM or AXIS:MM:MM_PER_MIN.
Move read_move(std::string const& word) {
  auto const refuse = [&]() -> Failure { return Failure({says::bad_move, {{"value", word}}}); };
  auto const first = word.find(':');
  if (first == std::string::npos || first == 0) throw refuse();
  Move move;
  move.axis = word.substr(0, first);
  auto const second = word.find(':', first + 1);
  auto const distance = parse_finite(std::string_view(word).substr(first + 1, second - first - 1));
  if (!distance || *distance == 0 || std::abs(*distance) > 1e6) throw refuse();
  move.distance_mm = *distance;
  if (second == std::string::npos) return move;
  move.feed_mm_per_min = parse_finite(std::string_view(word).substr(second + 1));
  if (!move.feed_mm_per_min || !(*move.feed_mm_per_min > 0)) throw refuse();
  return move;
}

void find_oscillations(ClosedLoopFigures& figures, motion::LoopRecord const& without,
                       motion::LoopRecord const& with, double T) {
  auto const [lowest, highest] = oscillation_band(T);
  for (auto const phase : {motion::MovePhase::travel, motion::MovePhase::rest}) {
    // Ways there and back are alike; the worse one counts.
    PhaseOscillation worst{.phase = phase, .without = {}, .with = {}};
    for (bool const back : {false, true}) {
      auto const record = motion::load_accelerations(without, phase, back);
      auto const found = motion::dominant_oscillation(record, T, lowest, highest);
      if (!(found.amplitude > worst.without.amplitude)) continue;
      worst.without = found;
      auto const same = motion::load_accelerations(with, phase, back);
      worst.with = same.size() == record.size()
                       ? std::optional(motion::amplitude_at(same, T, found.frequency))
                       : std::nullopt;
    }
    if (worst.without.amplitude > 0) figures.oscillations.push_back(worst);
  }
}

}  // namespace

std::pair<double, double> oscillation_band(double cycle_seconds) {
  return {4, std::min(200.0, 0.4 / cycle_seconds)};
}

PlantRun run_plant(PlantRequest const& request, CheckedMachine const& checked, bool searches_kv) {
  auto const& machine = checked.machine;
  auto const wanted = read_move(request.move);
  auto const index = axis_named(machine, wanted.axis);
  auto const& axis = machine.axes[index];
  auto const plant = read_plant(request.plant_path, wanted.axis);
  auto const image = image_of(machine, request.machine_path);
  auto runtime = start_runtime(request.machine_path, image);
  double const T = machine.cycle_time.seconds();
  double const highest = axis.velocity_limit * motion::units_per_um;
  double const feed = wanted.feed_mm_per_min
                          ? std::min(*wanted.feed_mm_per_min / 60 * motion::units_per_mm, highest)
                          : highest;
  // All of them are held in memory.
  constexpr double most_cycles = 5e6;
  double const cycles = 2 * std::abs(wanted.distance_mm) * motion::units_per_mm / (feed * T);
  if (!(cycles <= most_cycles)) {
    throw Failure(
        {says::slow_move, {{"cycles", format_rounded(cycles, 3)}, {"most", format_rounded(most_cycles, 1)}}});
  }
  motion::AxisMove const move{.axis = index,
                              .distance = wanted.distance_mm * motion::units_per_mm,
                              .velocity = feed * T,
                              .dynamics = path_dynamics(machine, index)};
  auto const& control = image.contents.axes[index].control;

  PlantRun run;
  run.cycle_seconds = T;
  auto& figures = run.figures;
  figures.axis = wanted.axis;
  figures.channel = move.dynamics.channel;
  figures.distance_mm = wanted.distance_mm;
  figures.feed_mm_per_min = feed / motion::units_per_mm * 60;
  figures.kv = plant.kv;
  figures.has_function = control.has_value();
  run.without = motion::simulate_loop(runtime, move, plant, false);
  run.with = control ? motion::simulate_loop(runtime, move, plant, true) : run.without;
  auto const& without = run.without;
  auto const& with = run.with;
  if (control) find_oscillations(figures, without, with, T);
  for (auto const& cycle : with.cycles) {
    figures.largest_additive = std::max(figures.largest_additive, std::abs(cycle.additive_velocity));
  }
  if (control) {
    figures.limit = control->limit;
    figures.limit_hit = figures.largest_additive >= control->limit * (1 - 1e-12);
  }
  figures.diverges_without = motion::diverges(without, T);
  figures.diverges_with = motion::diverges(with, T);
  if (!searches_kv) return run;
  figures.highest_kv_without = motion::highest_kv(runtime, move, plant, false);
  figures.highest_kv_with =
      control ? motion::highest_kv(runtime, move, plant, true) : figures.highest_kv_without;
  return run;
}

}  // namespace axisc
