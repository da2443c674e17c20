// The figures of a chain that all axes of a path have.
#pragma once

#include "analysis/tuning/suggestion/excitation.hpp"

#include <complex>
#include <vector>

namespace axisc::tuning {

struct Figures {
  double delay = 0;      ///< at 0 Hz, cycles
  double overshoot = 0;  ///< of a step, as a share
  /// Contour deviation at a corner of 90° (see motion::predict_corner()) for a path of one unit per cycle;
  /// multiplied by the velocity, a length.
  double corner = 0;
  double circle = 0;     ///< deviation on the task's circle at its velocity, position units
  double vibration = 1;  ///< the worst of the resonances
  std::vector<Vibration> resonances = {};
};

/// Response at θ rad per cycle.
[[nodiscard]] std::complex<double> gain(ImpulseResponse const& chain, double theta);

/// Cost: a millisecond or less.
class Judge {
 public:
  explicit Judge(Task const& task) : task_(task), excitation_(task) {}

  [[nodiscard]] Figures figures(ImpulseResponse const& chain) const;
  /// A quick estimate: corner and vibration are lower bounds, and single resonances are left out.
  [[nodiscard]] Figures estimate(ImpulseResponse const& chain) const;

 private:
  [[nodiscard]] double circle_of(ImpulseResponse const& chain) const;

  Task task_;
  Excitation excitation_;
};

}  // namespace axisc::tuning
