#include "bench/runtime/plain_loops.hpp"

namespace axisc::bench {
namespace {

double step_fir(PlainAxis& axis, double x) {
  std::size_t const length = axis.taps.size();
  axis.fir_ring[axis.fir_position] = x;
  double y = 0;
  std::size_t place = axis.fir_position;
  for (std::size_t k = 0; k < length; ++k) {
    y += axis.taps[k] * axis.fir_ring[place];
    place = place == 0 ? length - 1 : place - 1;
  }
  axis.fir_position = axis.fir_position + 1 == length ? 0 : axis.fir_position + 1;
  return y;
}

double step_average(PlainAxis& axis, double x) {
  double& oldest = axis.average_ring[axis.average_position];
  axis.average_sum += x - oldest;
  oldest = x;
  axis.average_position =
      axis.average_position + 1 == axis.average_ring.size() ? 0 : axis.average_position + 1;
  return axis.average_sum / static_cast<double>(axis.average_ring.size());
}

double step_delay(PlainAxis& axis, double x) {
  double& oldest = axis.delay_ring[axis.delay_position];
  double const y = oldest;
  oldest = x;
  axis.delay_position = axis.delay_position + 1 == axis.delay_ring.size() ? 0 : axis.delay_position + 1;
  return y;
}

}  // namespace

void PlainAxis::use_taps(std::vector<double> values) {
  taps = std::move(values);
  fir_ring.assign(taps.size(), 0);
}

void step_plain(std::vector<PlainAxis>& axes, double const* in, double* out) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    PlainAxis& axis = axes[i];
    double y = in[i];
    for (Biquad& section : axis.sections) {
      double const x = y;
      y = section.b0 * x + section.s1;
      section.s1 = section.b1 * x - section.a1 * y + section.s2;
      section.s2 = section.b2 * x - section.a2 * y;
    }
    if (!axis.taps.empty()) y = step_fir(axis, y);
    if (!axis.average_ring.empty()) y = step_average(axis, y);
    if (!axis.delay_ring.empty()) y = step_delay(axis, y);
    out[i] = y;
  }
}

}  // namespace axisc::bench
