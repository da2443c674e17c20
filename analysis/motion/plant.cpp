#include "analysis/motion/plant.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::motion {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
/// Far below the period of any oscillation that such mechanics have.
constexpr double longest_substep = 62.5e-6;
constexpr double furthest = 1e4;

}  // namespace

Plant::Plant(PlantParameters const& parameters, double cycle) : p_(parameters) {
  proportional_ = two_pi * p_.velocity_bandwidth * (p_.motor_mass + p_.load_mass + p_.structure_mass);
  double const omega = two_pi * p_.structure_frequency;
  structure_stiffness_ = p_.structure_mass * omega * omega;
  structure_viscosity_ = 2 * p_.structure_damping * p_.structure_mass * omega;
  substeps_ = static_cast<std::size_t>(std::max(1.0, std::ceil(cycle / longest_substep - 1e-9)));
  h_ = cycle / static_cast<double>(substeps_);
  has_teeth_ = p_.tooth_pitch > 0 && p_.transmission_error > 0;
  auto const late = static_cast<std::size_t>(std::llround(p_.dead_time / h_));
  commands_.assign(has_teeth_ ? late : late / substeps_ + 1, 0.0);
  if (!has_teeth_) map_ = cycle_map(late % substeps_);
}

Plant::State Plant::derivative(State const& state, double velocity) const {
  auto const& [xm, vm, xl, vl, xs, vs, integral] = state;
  double const delta = has_teeth_ ? p_.transmission_error * std::sin(two_pi * xm / p_.tooth_pitch) : 0;
  double const coupling = p_.stiffness * (xm - xl + delta) + p_.damping * (vm - vl);
  double const structure = structure_stiffness_ * (xs - xl) + structure_viscosity_ * (vs - vl);
  double const error = velocity - vm;
  double const drive = proportional_ * (error + integral);
  return {vm,
          (drive - coupling) / p_.motor_mass,
          vl,
          (coupling + structure) / p_.load_mass,
          vs,
          p_.structure_mass > 0 ? -structure / p_.structure_mass : 0,
          p_.velocity_reset_time > 0 ? error / p_.velocity_reset_time : 0};
}

/// Runge and Kutta's classical method; the command is constant within a substep.
Plant::State Plant::substep(State const& state, double velocity) const {
  auto const moved = [](State a, double factor, State const& b) {
    for (std::size_t i = 0; i < states; ++i) a[i] += factor * b[i];
    return a;
  };
  State const k1 = derivative(state, velocity);
  State const k2 = derivative(moved(state, h_ / 2, k1), velocity);
  State const k3 = derivative(moved(state, h_ / 2, k2), velocity);
  State const k4 = derivative(moved(state, h_, k3), velocity);
  State next = state;
  for (std::size_t i = 0; i < states; ++i) next[i] += h_ / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  return next;
}

/// The columns are the results of unit states and unit commands.
Plant::CycleMap Plant::cycle_map(std::size_t substeps_before) const {
  auto const cycle = [&](State state, double before, double behind) {
    for (std::size_t n = 0; n < substeps_; ++n) state = substep(state, n < substeps_before ? before : behind);
    return state;
  };
  CycleMap map;
  for (std::size_t i = 0; i < states; ++i) {
    State unit{};
    unit[i] = 1;
    map.columns[i] = cycle(unit, 0, 0);
  }
  map.before = cycle({}, 1, 0);
  map.behind = cycle({}, 0, 1);
  return map;
}

void Plant::step(double velocity) {
  commands_.push_back(velocity);
  if (has_teeth_) {
    for (std::size_t n = 0; n < substeps_; ++n) {
      if (n > 0) commands_.push_back(velocity);
      state_ = substep(state_, commands_.front());
      commands_.pop_front();
    }
    return;
  }
  State next{};
  for (std::size_t i = 0; i < states; ++i) {
    next[i] = map_.before[i] * commands_[0] + map_.behind[i] * commands_[1];
  }
  for (std::size_t k = 0; k < states; ++k) {
    for (std::size_t i = 0; i < states; ++i) next[i] += map_.columns[k][i] * state_[k];
  }
  state_ = next;
  commands_.pop_front();
}

PlantMotion Plant::motion() const {
  State const slope = derivative(state_, 0);
  return {.motor_position = state_[0],
          .motor_velocity = state_[1],
          .load_position = state_[2],
          .load_velocity = state_[3],
          .load_acceleration = slope[3],
          .structure_position = state_[4],
          .structure_velocity = state_[5]};
}

bool Plant::lost() const {
  return std::any_of(state_.begin(), state_.end(),
                     [](double value) { return !(std::abs(value) < furthest); });
}

}  // namespace axisc::motion
