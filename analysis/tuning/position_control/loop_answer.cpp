#include "analysis/tuning/position_control/loop_answer.hpp"

#include "design/filter_analysis.hpp"
#include "design/filter_design.hpp"
#include "design/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::tuning {
namespace {

/// Long enough for the mechanics to ring out and for the position loop to settle.
double ringing_seconds(double kv) {
  return std::clamp(10 / kv, 4.0, 60.0);
}

std::complex<double> stage_gain(machine::PositionControlStage const& stage, design::Hertz frequency,
                                design::CycleTime cycle_time) {
  std::complex<double> gain = std::min(stage.weight_numerator / stage.weight_denominator, largest_weight);
  auto const pass = [&](design::FilterDesign const& filter) {
    gain *= design::response(filter, frequency, cycle_time);
  };
  if (stage.oscillator) {
    pass(design::design_oscillator(*stage.oscillator, cycle_time, design::Precision::quick));
  }
  for (auto const& filter : stage.filters) {
    pass(design::design_filter(filter, cycle_time, design::Precision::quick));
  }
  return gain;
}

}  // namespace

LoopAnswer::LoopAnswer(motion::PlantParameters const& plant, design::CycleTime cycle_time)
    : plant_(plant), T_(cycle_time.seconds()) {
  plant_.transmission_error = 0;
  motion::Plant axis(plant_, T_);
  double const end = ringing_seconds(plant_.kv) / T_;
  for (double additive = 1; static_cast<double>(motions_.size()) < end; additive = 0) {
    auto const motion = axis.motion();
    motions_.push_back(motion);
    double const x =
        plant_.feedback == motion::PositionFeedback::motor ? motion.motor_position : motion.load_position;
    axis.step(additive - plant_.kv * x);
  }
}

AnswerAt LoopAnswer::at(double frequency) const {
  auto const turn = std::polar(1.0, -2 * std::numbers::pi * frequency * T_);
  AnswerAt answer{};
  std::complex<double> motor_position = 0;
  // Horner's scheme: Σ x[n] z^-n.
  for (std::size_t n = motions_.size(); n-- > 0;) {
    auto const& motion = motions_[n];
    answer.motor = answer.motor * turn + motion.motor_velocity;
    answer.direct = answer.direct * turn + motion.load_velocity;
    answer.load = answer.load * turn + motion.load_position;
    answer.load_acceleration = answer.load_acceleration * turn + motion.load_acceleration;
    motor_position = motor_position * turn + motion.motor_position;
  }
  bool const uses_motor = plant_.feedback == motion::PositionFeedback::motor;
  answer.set = -plant_.kv * (uses_motor ? motor_position : answer.load);
  answer.setpoint = plant_.kv + plant_.feedforward * (1.0 - turn) / T_;
  return answer;
}

bool has_peak(LoopAnswer const& answer, double frequency, double reach) {
  constexpr int steps = 40;
  double largest = 0;
  int at = 0;
  for (int i = -steps; i <= steps; ++i) {
    double const here = std::abs(answer.at(frequency * (1 + reach * i / steps)).load_acceleration);
    if (here > largest) {
      largest = here;
      at = i;
    }
  }
  return largest > 0 && std::abs(at) < steps;
}

double shift_at(AnswerAt const& answer, double frequency, machine::PositionControl const& control,
                design::CycleTime cycle_time) {
  std::complex<double> measured = 0;
  std::complex<double> loop = 1;
  for (auto const& stage : control.stages) {
    auto const gain = stage_gain(stage, {frequency}, cycle_time);
    switch (stage.mode) {
      case machine::StageMode::direct:
        measured += gain * answer.direct;
        loop += gain * answer.direct;
        break;
      case machine::StageMode::indirect:
        measured += gain * answer.motor;
        loop += gain * answer.motor;
        break;
      case machine::StageMode::set_point:
        measured += gain * (1.0 + answer.set);
        loop += gain * answer.set;
        break;
    }
  }
  return std::abs(answer.load * measured / loop * answer.setpoint);
}

}  // namespace axisc::tuning
