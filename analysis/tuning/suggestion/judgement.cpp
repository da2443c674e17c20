#include "analysis/tuning/suggestion/judgement.hpp"

#include "analysis/motion/contour/contour_predictions.hpp"
#include "analysis/motion/contour/ramp_answer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace axisc::tuning {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

double overshoot_of(std::vector<double> const& taps) {
  double step = 0;
  double highest = 1;
  for (double const tap : taps) highest = std::max(highest, step += tap);
  return highest - 1;
}

/// A chain that does not follow a ramp has no corner.
double corner_of(ImpulseResponse const& chain) {
  auto const answer = motion::chain_answer(motion::ramp_answer(chain.taps));
  return answer ? motion::predict_corner({&*answer, 1}, 1, right_angle).deviation : 0;
}

/// From the median, where the mean distance is least.
double spread_of(std::vector<double> const& taps) {
  double sum = 0;
  std::size_t median = 0;
  while (median + 1 < taps.size() && (sum += taps[median]) < 0.5) ++median;
  double spread = 0;
  for (std::size_t k = 0; k < taps.size(); ++k) {
    spread += taps[k] * std::abs(static_cast<double>(k) - static_cast<double>(median));
  }
  return spread;
}

/// How far the path passes from the corner itself, on which one axis ends a ramp and the other begins one.
double corner_at_least(ImpulseResponse const& chain) {
  double nearest = std::numeric_limits<double>::infinity();
  double x = -chain.delay;
  double y = 0;
  double n = 0;
  double step = 0;
  for (double const tap : chain.taps) {
    n += 1;
    step += tap;
    // To  y + step  and  n - delay - y.
    double const dx = 1 - step;
    double const length = dx * dx + step * step;
    double const share = length > 0 ? std::clamp(-(x * dx + y * step) / length, 0.0, 1.0) : 0;
    nearest = std::min(nearest, std::hypot(x + share * dx, y + share * step));
    y += step;
    x = n - chain.delay - y;
  }
  return nearest;
}

}  // namespace

std::complex<double> gain(ImpulseResponse const& chain, double theta) {
  auto const turn = std::polar(1.0, -theta);
  std::complex<double> sum = 0;
  // NOLINTNEXTLINE(modernize-loop-convert): ranges of clang 14 and of this library do not go together
  for (auto tap = chain.taps.rbegin(); tap != chain.taps.rend(); ++tap) sum = sum * turn + *tap;
  return sum;
}

Figures Judge::estimate(ImpulseResponse const& chain) const {
  return {.delay = chain.delay,
          .overshoot = overshoot_of(chain.taps),
          .corner = corner_at_least(chain),
          .circle = circle_of(chain),
          .vibration = excitation_.at_least_after(chain)};
}

ChainSummary Judge::summary(ImpulseResponse const& chain) const {
  constexpr double rounding = 1e-12;
  auto const& taps = chain.taps;
  return {.delay = chain.delay,
          .taps = taps.size(),
          .is_positive = std::all_of(taps.begin(), taps.end(), [](double tap) { return tap > -rounding; }),
          .spread = spread_of(taps),
          .ringing = excitation_.ringing(chain)};
}

Figures Judge::bound(ChainSummary const& first, ChainSummary const& second) const {
  auto ringing = first.ringing;
  for (std::size_t i = 0; i < ringing.size(); ++i) ringing[i] *= second.ringing[i];
  double const delay = first.delay + second.delay;
  return {.delay = delay,
          .overshoot = 0,
          .corner = std::max(first.spread, second.spread) / std::numbers::sqrt2,
          .circle = 0,
          .vibration = excitation_.at_least_ringing(ringing, first.taps + second.taps - 1, delay)};
}

double Judge::circle_of(ImpulseResponse const& chain) const {
  return task_.radius * std::abs(1 - std::abs(gain(chain, task_.velocity / task_.radius)));
}

Figures Judge::figures(ImpulseResponse const& chain) const {
  Figures figures{.delay = chain.delay,
                  .overshoot = overshoot_of(chain.taps),
                  .corner = corner_of(chain),
                  .circle = circle_of(chain),
                  .vibration = 0,
                  .resonances = excitation_.after(chain)};
  for (auto const& resonance : figures.resonances) {
    figures.vibration = std::max(figures.vibration, resonance.worst);
  }
  return figures;
}

}  // namespace axisc::tuning
