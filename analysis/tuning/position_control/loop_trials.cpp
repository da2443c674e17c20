#include "analysis/tuning/position_control/loop_trials.hpp"

#include "codegen/image_writer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <variant>

namespace axisc::tuning {
namespace {

constexpr double um_per_m = 1e6;
constexpr double units_per_m = 1e7;
/// m/s²: a smaller acceleration after a motion that does not grow is not an oscillation.
constexpr double still = 0.005;
/// m/s²: no machine survives it.
constexpr double violent = 1e3;
/// µm/s, far beyond any velocity in a loop that is not lost.
constexpr double no_limit = 1e15;
/// Settings that one image holds.
constexpr std::size_t batch = 256;

image::RuntimeHost host_of(machine::Machine const& machine) {
  auto created =
      image::RuntimeHost::create(codegen::write_image(machine, {.strip = true, .image_version = 0}));
  if (!std::holds_alternative<image::RuntimeHost>(created)) {
    throw std::logic_error("the runtime refuses a candidate");
  }
  return std::get<image::RuntimeHost>(std::move(created));
}

image::RuntimeHost stages_of(std::span<machine::PositionControl const> controls,
                             design::CycleTime cycle_time) {
  machine::Machine machine;
  machine.name = "candidates";
  machine.cycle_time = cycle_time;
  for (auto const& control : controls) {
    auto& axis = machine.axes.emplace_back();
    axis.number = static_cast<std::uint32_t>(machine.axes.size());
    axis.name = std::to_string(axis.number);
    axis.velocity_limit = no_limit;
    axis.position_control = control;
    axis.position_control->limit_factor = 1000;
  }
  return host_of(machine);
}

double strength(std::span<double const> values) {
  double const sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

bool grows_in(std::span<double const> rest) {
  auto const third = rest.size() / 3;
  double const late = strength(rest.last(third));
  return !(late < violent) || (late > still && late > strength(rest.subspan(third, third)));
}

}  // namespace

image::RuntimeHost loop_runtime(LoopTask const& task, machine::PositionControl const& control) {
  machine::Machine machine;
  machine.name = "loop";
  machine.cycle_time = task.cycle_time;
  machine.axes = {task.axis};
  machine.axes[0].position_control.reset();
  if (!control.stages.empty()) machine.axes[0].position_control = control;
  return host_of(machine);
}

LoopTrials::LoopTrials(LoopTask const& task, motion::PlantParameters const& plant)
    : task_(task), plant_(plant) {
  double const T = task.cycle_time.seconds();
  plant_.transmission_error = 0;
  auto runtime = loop_runtime(task, {});
  auto record = motion::simulate_loop(runtime, move_of(task), plant, false);
  diverges_ = motion::diverges(record, T);
  if (diverges_) return;
  record.cycles.resize(counted_cycles(record));
  cycles_ = std::move(record.cycles);
  auto const first = [&](auto const& is_wanted) {
    return static_cast<std::size_t>(std::find_if(cycles_.begin(), cycles_.end(), is_wanted) -
                                    cycles_.begin());
  };
  using motion::LoopCycle, motion::MovePhase;
  rest_begin_ = first([](LoopCycle const& cycle) { return cycle.phase == MovePhase::rest; });
  travel_begin_ = first([](LoopCycle const& cycle) { return cycle.phase == MovePhase::travel; });
  travel_end_ = travel_begin_;
  while (travel_end_ < rest_begin_ && cycles_[travel_end_].phase == MovePhase::travel) ++travel_end_;
  std::vector<double> accelerations;
  for (auto const& cycle : cycles_) accelerations.push_back(cycle.load_acceleration);
  swings_ = swings_of(accelerations);
}

std::vector<double> LoopTrials::swings_of(std::span<double const> accelerations) const {
  LoadAccelerations const load{
      .travel = travel_begin_ < travel_end_
                    ? accelerations.subspan(travel_begin_, travel_end_ - travel_begin_)
                    : std::span<double const>(),
      .rest = accelerations.subspan(rest_begin_)};
  std::vector<double> found;
  for (auto const& resonance : task_.resonances) {
    found.push_back(swing(load, task_.cycle_time.seconds(), resonance));
  }
  return found;
}

std::vector<Trial> LoopTrials::with(std::span<machine::PositionControl const> controls) const {
  std::vector<Trial> trials;
  while (!controls.empty()) {
    auto const now = controls.first(std::min(batch, controls.size()));
    controls = controls.subspan(now.size());
    auto const count = now.size();
    auto runtime = stages_of(now, task_.cycle_time);
    static_cast<void>(runtime.reset_all(0));
    std::vector<motion::Plant> plants(count, motion::Plant(plant_, task_.cycle_time.seconds()));
    std::vector<double> v(count), set(count), motor(count), direct(count), additive(count), increments(count),
        shifts(count, 0.0);
    std::vector<std::vector<double>> accelerations(count, std::vector<double>(cycles_.size()));
    bool const uses_motor = plant_.feedback == motion::PositionFeedback::motor;
    for (std::size_t n = 0; n < cycles_.size(); ++n) {
      auto const& cycle = cycles_[n];
      for (std::size_t i = 0; i < count; ++i) {
        auto const added = plants[i].motion();
        shifts[i] = std::max(shifts[i], std::abs(added.load_position) * units_per_m);
        v[i] = -plant_.kv * (uses_motor ? added.motor_position : added.load_position);
        set[i] = cycle.set_velocity + v[i] * um_per_m;
        motor[i] = cycle.motor_velocity + added.motor_velocity * um_per_m;
        direct[i] = cycle.load_velocity + added.load_velocity * um_per_m;
        accelerations[i][n] = cycle.load_acceleration + added.load_acceleration;
      }
      static_cast<void>(
          runtime.step_velocity({.set = set, .motor = motor, .direct = direct}, additive, increments));
      for (std::size_t i = 0; i < count; ++i) plants[i].step(v[i] + additive[i] / um_per_m);
    }
    for (std::size_t i = 0; i < count; ++i) {
      auto const& record = accelerations[i];
      Trial trial{
          .grows = grows_in(std::span(record).subspan(rest_begin_)), .swings = {}, .shift = shifts[i]};
      if (!trial.grows) trial.swings = swings_of(record);
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

}  // namespace axisc::tuning
