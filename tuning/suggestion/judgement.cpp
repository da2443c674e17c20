#include "tuning/suggestion/judgement.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::tuning {
namespace {

double overshoot_of(std::vector<double> const& taps) {
  double step = 0;
  double highest = 1;
  for (double const tap : taps) highest = std::max(highest, step += tap);
  return highest - 1;
}

/// Of the answer to a ramp,  r[n+1] = r[n] + Σ_{k≤n} b[k],  what is left after its delay.
double corner_of(ImpulseResponse const& chain) {
  double const delay = chain.delay;
  auto const before = std::floor(delay);
  double answer = 0;
  double step = 0;
  double largest = 0;
  double n = 0;
  for (double const tap : chain.taps) {
    step += tap;
    if (n == before) largest = std::max(largest, std::abs(answer + (delay - before) * step));
    largest = std::max(largest, std::abs(answer - std::max(0.0, n - delay)));
    answer += step;
    n += 1;
  }
  return largest;
}

}  // namespace

std::complex<double> gain(ImpulseResponse const& chain, double theta) {
  auto const turn = std::polar(1.0, -theta);
  std::complex<double> sum = 0;
  // NOLINTNEXTLINE(modernize-loop-convert): ranges of clang 14 and of this library do not go together
  for (auto tap = chain.taps.rbegin(); tap != chain.taps.rend(); ++tap) sum = sum * turn + *tap;
  return sum;
}

Figures Judge::figures(ImpulseResponse const& chain) const {
  Figures figures{.delay = chain.delay,
                  .overshoot = overshoot_of(chain.taps),
                  .corner = corner_of(chain),
                  .circle = task_.radius * std::abs(1 - std::abs(gain(chain, task_.velocity / task_.radius))),
                  .vibration = 0,
                  .resonances = excitation_.after(chain)};
  for (auto const& resonance : figures.resonances) {
    figures.vibration = std::max(figures.vibration, resonance.worst);
  }
  return figures;
}

}  // namespace axisc::tuning
