#include "analysis/motion/closed_loop.hpp"

#include "analysis/motion/interpolator.hpp"
#include "analysis/motion/look_ahead.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::motion {
namespace {

constexpr double units_per_m = 1e7;
constexpr double um_per_m = 1e6;
/// m/s²: a smaller acceleration after a motion that does not grow is not an oscillation.
constexpr double still = 0.005;

/// Setpoints of the move, cycle by cycle.
class MoveRecorder final : public SampleSink {
 public:
  MoveRecorder(std::vector<LoopCycle>& cycles, double travel) : cycles_(cycles), travel_(travel) {}
  void sample(Point const& setpoint, double velocity, PathBlock const& block) override {
    bool const constant = velocity >= travel_ * (1 - 1e-9);
    LoopCycle cycle;
    cycle.phase = constant ? MovePhase::travel : MovePhase::ramp;
    cycle.back = block.index > 1;
    cycle.setpoint = setpoint[0];
    cycles_.push_back(cycle);
  }
  void corner(PathBlock const&, PathBlock const*, double, BlockMotion const&) override {}

 private:
  std::vector<LoopCycle>& cycles_;
  double travel_;
};

std::vector<LoopCycle> planned(AxisMove const& move, std::size_t rest_cycles) {
  std::vector<LoopCycle> cycles;
  MoveRecorder recorder(cycles, move.velocity);
  Interpolator interpolator(recorder);
  LookAhead look_ahead(PathLimits(move.dynamics), false, interpolator);
  Point from{};
  for (double const end : {move.distance, 0.0}) {
    look_ahead.begin(from, {}, 1);
    ProgrammedBlock block;
    block.end[0] = end;
    block.feed = move.velocity;
    look_ahead.add(block);
    look_ahead.stop();
    from = block.end;
    LoopCycle rest = cycles.back();
    rest.phase = MovePhase::rest;
    cycles.insert(cycles.end(), rest_cycles, rest);
  }
  return cycles;
}

/// Root mean square of the load's acceleration.
double strength(std::vector<LoopCycle> const& cycles, std::size_t first, std::size_t count) {
  double sum = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    sum += cycles[i].load_acceleration * cycles[i].load_acceleration;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

}  // namespace

LoopRecord simulate_loop(image::RuntimeHost& runtime, AxisMove const& move, PlantParameters const& plant,
                         bool with_function) {
  double const T = runtime.cycle_time().seconds();
  LoopRecord record;
  record.cycles = planned(move, static_cast<std::size_t>(rest_seconds / T));
  static_cast<void>(runtime.reset_all(0));
  std::size_t const axes = runtime.axis_count();
  std::vector<double> setpoints(axes), filtered(axes), v_set(axes), v_motor(axes), v_direct(axes),
      v_add(axes), increments(axes);
  Plant axis(plant, T);
  double before = 0;
  for (std::size_t n = 0; n < record.cycles.size(); ++n) {
    auto& cycle = record.cycles[n];
    setpoints[move.axis] = cycle.setpoint;
    static_cast<void>(runtime.step(setpoints, filtered));
    double const x_set = filtered[move.axis] / units_per_m;
    auto const motion = axis.motion();
    double const x = plant.feedback == PositionFeedback::motor ? motion.motor_position : motion.load_position;
    double const v = plant.kv * (x_set - x) + plant.feedforward * (x_set - before) / T;
    before = x_set;
    v_set[move.axis] = v * um_per_m;
    v_motor[move.axis] = motion.motor_velocity * um_per_m;
    v_direct[move.axis] = motion.load_velocity * um_per_m;
    static_cast<void>(
        runtime.step_velocity({.set = v_set, .motor = v_motor, .direct = v_direct}, v_add, increments));
    double const additive = v_add[move.axis];
    axis.step(v + (with_function ? additive / um_per_m : 0));
    cycle.load_position = motion.load_position * units_per_m;
    cycle.load_acceleration = motion.load_acceleration;
    cycle.set_velocity = v_set[move.axis];
    cycle.motor_velocity = v_motor[move.axis];
    cycle.load_velocity = v_direct[move.axis];
    cycle.additive_velocity = additive;
    if (axis.lost()) {
      record.lost = true;
      record.cycles.resize(n + 1);
      break;
    }
  }
  return record;
}

std::vector<double> load_accelerations(LoopRecord const& record, MovePhase phase, bool back) {
  std::vector<double> found;
  for (auto const& cycle : record.cycles) {
    if (cycle.phase == phase && cycle.back == back) found.push_back(cycle.load_acceleration);
  }
  if (phase == MovePhase::rest) found.resize(found.size() / 3);
  return found;
}

bool diverges(LoopRecord const& record, double cycle_seconds) {
  if (record.lost) return true;
  auto const rest = static_cast<std::size_t>(rest_seconds / cycle_seconds);
  auto const part = rest / 6;
  std::size_t const begin = record.cycles.size() - rest;
  // A second later a damped oscillation has long died down.
  double const early = strength(record.cycles, begin + part, part);
  double const late = strength(record.cycles, begin + 5 * part, part);
  return late > still && late > 0.7 * early;
}

std::optional<double> highest_kv(image::RuntimeHost& runtime, AxisMove const& move, PlantParameters plant,
                                 bool with_function) {
  double const T = runtime.cycle_time().seconds();
  auto const keeps = [&](double kv) {
    plant.kv = kv;
    return !diverges(simulate_loop(runtime, move, plant, with_function), T);
  };
  double low = 0;
  double high = 1;
  while (keeps(high)) {
    if (high == kv_search_end) return std::nullopt;
    low = high;
    high = std::min(high * 1.2, kv_search_end);
  }
  if (low == 0) return 0;
  while (high - low > 0.01 * low) {
    double const middle = (low + high) / 2;
    (keeps(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace axisc::motion
