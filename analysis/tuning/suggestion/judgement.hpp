// The figures of a chain that all axes of a path have.
#pragma once

#include "analysis/tuning/suggestion/excitation.hpp"

#include <complex>
#include <cstddef>
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

/// What is needed of a chain to bound what it does in series with others.
struct ChainSummary {
  double delay = 0;  ///< cycles
  std::size_t taps = 0;
  bool is_positive = false;  ///< no tap below 0: it neither overshoots, nor does a series of such chains
  /// Least mean distance of the taps from a cycle, min Σ b[k] |k - m|: over √2, of a chain without negative
  /// taps, at most the deviation at a corner.
  double spread = 0;
  std::vector<std::complex<double>> ringing;  ///< Excitation::ringing()
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
  [[nodiscard]] ChainSummary summary(ImpulseResponse const& chain) const;
  /// Of two chains without negative taps in series: corner and vibration are lower bounds, which are at most
  /// those of estimate(), and the circle is left out. Along the bisector of a corner the setpoint is convex,
  /// so that a second chain does not bring its path nearer to the corner. Cost: less than a microsecond.
  [[nodiscard]] Figures bound(ChainSummary const& first, ChainSummary const& second) const;

 private:
  [[nodiscard]] double circle_of(ImpulseResponse const& chain) const;

  Task task_;
  Excitation excitation_;
};

}  // namespace axisc::tuning
