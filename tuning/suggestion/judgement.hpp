// The figures of a chain that all axes of a path have.
#pragma once

#include "tuning/suggestion/excitation.hpp"

#include <complex>
#include <vector>

namespace axisc::tuning {

struct Figures {
  double delay = 0;      ///< at 0 Hz, cycles
  double overshoot = 0;  ///< of a step, as a share
  /// Largest remainder of a change of velocity, max |R(τ)| (see motion::ChainAnswer), in cycles: times the change of an
  /// axis' velocity at a corner it is the axis error, or a bound of it where the chain is not symmetrical.
  double corner = 0;
  double circle = 0;     ///< deviation on the task's circle at its velocity, position units
  double vibration = 1;  ///< the worst of the resonances
  std::vector<Vibration> resonances = {};
};

/// Response at θ rad per cycle.
[[nodiscard]] std::complex<double> gain(ImpulseResponse const& chain, double theta);

class Judge {
 public:
  explicit Judge(Task const& task) : task_(task), excitation_(task) {}

  [[nodiscard]] Figures figures(ImpulseResponse const& chain) const;

 private:
  Task task_;
  Excitation excitation_;
};

}  // namespace axisc::tuning
