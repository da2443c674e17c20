// Drive and mechanics of an axis with rack and pinion: motor and load as two masses with the drive train's
// spring between them, and a structure (column, cross-beam) that swings on the load.
//
//     m_M x_M'' = F - F_c
//     m_L x_L'' = F_c + F_S
//     m_S x_S'' = - F_S
//     F_c = c (x_M - x_L + δ) + d (x_M' - x_L'),  δ = A sin(2π x_M / p)   (the teeth)
//     F_S = c_S (x_S - x_L) + d_S (x_S' - x_L')
//     F   = K_p (v - x_M') + K_i ∫ (v - x_M') dt                          (the drive's velocity loop)
// v is the commanded velocity, the drive's dead time later. Everything in SI units; rotary parts count with
// the mass that they have at the pinion.
#pragma once

#include <array>
#include <cstddef>
#include <deque>

namespace axisc::motion {

enum class PositionFeedback { direct, motor };

struct PlantParameters {
  double motor_mass = 0;           ///< m_M, kg
  double load_mass = 0;            ///< m_L, kg
  double stiffness = 0;            ///< c, N/m
  double damping = 0;              ///< d, N s/m
  double tooth_pitch = 0;          ///< p, m; 0: no teeth
  double transmission_error = 0;   ///< A, m
  double structure_mass = 0;       ///< m_S, kg; 0: none
  double structure_frequency = 0;  ///< sqrt(c_S/m_S)/2π, Hz
  double structure_damping = 0;    ///< d_S / (2 sqrt(c_S m_S))
  double dead_time = 0;            ///< s
  double velocity_bandwidth = 0;   ///< K_p / (2π (m_M + m_L + m_S)), Hz
  double velocity_reset_time = 0;  ///< K_p / K_i, s; 0: no integral part
  double kv = 0;                   ///< of the position loop, 1/s
  double feedforward = 0;          ///< share of the setpoint's velocity that is added to the command, 0..1
  PositionFeedback feedback = PositionFeedback::direct;
};

/// The motion that can be measured, in m, m/s and m/s².
struct PlantMotion {
  double motor_position = 0, motor_velocity = 0;
  double load_position = 0, load_velocity = 0, load_acceleration = 0;
  double structure_position = 0, structure_velocity = 0;
};

class Plant {
 public:
  /// At rest at 0. `cycle` in s: commands come once per cycle.
  Plant(PlantParameters const& parameters, double cycle);

  /// One NC cycle with this commanded velocity. Without teeth the plant is linear, and a cycle costs one
  /// product with a matrix.
  void step(double velocity);
  [[nodiscard]] PlantMotion motion() const;
  /// Positions beyond any machine: the loop has become unstable.
  [[nodiscard]] bool lost() const;

 private:
  static constexpr std::size_t states = 7;  ///< x_M, v_M, x_L, v_L, x_S, v_S, ∫
  using State = std::array<double, states>;
  /// A cycle as a linear map of the state and of the two commands that reach the drive within it.
  struct CycleMap {
    std::array<State, states> columns{};
    State before{}, behind{};  ///< the dead time ends within the cycle: commands before and after this moment
  };
  [[nodiscard]] State derivative(State const& state, double velocity) const;
  [[nodiscard]] State substep(State const& state, double velocity) const;
  [[nodiscard]] CycleMap cycle_map(std::size_t substeps_before) const;

  PlantParameters p_;
  double proportional_ = 0;  ///< K_p
  double structure_stiffness_ = 0, structure_viscosity_ = 0;
  std::size_t substeps_ = 1;
  double h_ = 0;  ///< duration of a substep
  bool has_teeth_ = false;
  CycleMap map_;  ///< without teeth
  std::deque<double>
      commands_;  ///< that have not reached the drive yet, one per substep, without teeth one per cycle
  State state_{};
};

}  // namespace axisc::motion
