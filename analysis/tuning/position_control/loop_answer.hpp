// The effect of an additive velocity on a loop without function, over frequency. The plant has no teeth here:
// the loop is linear.
#pragma once

#include "analysis/motion/plant.hpp"
#include "analysis/tuning/suggestion/task.hpp"
#include "configuration/machine/machine.hpp"

#include <complex>
#include <vector>

namespace axisc::tuning {

/// The control limits the weight of a stage to this.
inline constexpr double largest_weight = 7;

/// Answers to v_add = 1 at a frequency, in SI units.
struct AnswerAt {
  std::complex<double> set, motor, direct;  ///< velocities that stages measure
  std::complex<double> load;                ///< position
  std::complex<double> load_acceleration;
  std::complex<double>
      setpoint;  ///< Kv + f (1 - z^-1)/T: what the loop makes of a setpoint before it adds v_add
};

class LoopAnswer {
 public:
  LoopAnswer(motion::PlantParameters const& plant, design::CycleTime cycle_time);

  [[nodiscard]] AnswerAt at(double frequency) const;

 private:
  motion::PlantParameters plant_;
  double T_;
  std::vector<motion::PlantMotion> motions_;  ///< after an additive velocity of 1 m/s in the first cycle
};

/// Whether the loop resonates within `reach` (a share) of the frequency: the load's acceleration has a peak
/// there.
[[nodiscard]] bool has_peak(LoopAnswer const& answer, double frequency, double reach);

/// How far the function moves the load of an axis that goes to and fro like a sine of amplitude 1, for
/// instance on a circle:
///     v_add = -Σ G_i u_i / (1 + Σ G_i P_i),
/// G_i being a stage with its weight, u_i the velocity that it measures without function, P_i its answer.
[[nodiscard]] double shift_at(AnswerAt const& answer, double frequency,
                              machine::PositionControl const& control, design::CycleTime cycle_time);

}  // namespace axisc::tuning
