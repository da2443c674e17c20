#include "motion/plant.hpp"

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
  commands_.assign(static_cast<std::size_t>(std::llround(p_.dead_time / h_)), 0.0);
}

Plant::State Plant::derivative(State const& state, double velocity) const {
  auto const& [xm, vm, xl, vl, xs, vs, integral] = state;
  double const delta =
      p_.tooth_pitch > 0 ? p_.transmission_error * std::sin(two_pi * xm / p_.tooth_pitch) : 0;
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
void Plant::step(double velocity) {
  auto const moved = [](State a, double factor, State const& b) {
    for (std::size_t i = 0; i < states; ++i) a[i] += factor * b[i];
    return a;
  };
  for (std::size_t n = 0; n < substeps_; ++n) {
    commands_.push_back(velocity);
    double const v = commands_.front();
    commands_.pop_front();
    State const k1 = derivative(state_, v);
    State const k2 = derivative(moved(state_, h_ / 2, k1), v);
    State const k3 = derivative(moved(state_, h_ / 2, k2), v);
    State const k4 = derivative(moved(state_, h_, k3), v);
    for (std::size_t i = 0; i < states; ++i) state_[i] += h_ / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
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
