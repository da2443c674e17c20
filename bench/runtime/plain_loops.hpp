// What a programmer writes without a library: one axis after the other, transposed direct form II, a ring
// buffer for a FIR filter, a running sum (which drifts) for a moving average. The yardstick of the
// benchmarks; compiled with -O2.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace axisc::bench {

struct Biquad {
  double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
  double s1 = 0, s2 = 0;
};

/// The filters of one axis: sections, then a FIR kernel or a moving average, then a delay.
struct PlainAxis {
  std::vector<Biquad> sections;
  std::vector<double> taps;
  std::vector<double> fir_ring;
  std::size_t fir_position = 0;
  std::vector<double> average_ring;
  std::size_t average_position = 0;
  double average_sum = 0;
  std::vector<double> delay_ring;
  std::size_t delay_position = 0;

  void use_taps(std::vector<double> values);
  void use_average(std::size_t length) { average_ring.assign(length, 0); }
  void use_delay(std::size_t cycles) { delay_ring.assign(cycles, 0); }
};

/// One cycle of all axes.
void step_plain(std::vector<PlainAxis>& axes, double const* in, double* out);

}  // namespace axisc::bench
