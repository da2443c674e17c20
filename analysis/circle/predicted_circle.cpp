#include "analysis/circle/predicted_circle.hpp"

#include "analysis/motion/contour/filtered_circle.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace axisc::circle {

namespace {

/// Enough for an ellipse: its radius is smooth.
constexpr int directions = 3600;

}  // namespace

double PredictedCircle::deviation_at(double angle, Sense sense) const {
  // M M^T of  (u, v) = R M (cos ψ, sin ψ):  the ellipse is  p^T (M M^T)^-1 p = R².
  double const uu = gain_u * gain_u;
  double const vv = gain_v * gain_v;
  double const uv = sign_of(sense) * gain_u * gain_v * std::sin(phase);
  double const determinant = uu * vv - uv * uv;
  double const c = std::cos(angle);
  double const s = std::sin(angle);
  return radius * (std::sqrt(determinant / (vv * c * c - 2 * uv * c * s + uu * s * s)) - 1);
}

Deviations PredictedCircle::deviations() const {
  motion::FilteredCircle const filtered{.x = std::polar(gain_u, -phase / 2),
                                        .y = std::polar(gain_v, phase / 2)};
  auto const axes = filtered.semi_axes();
  double const large = radius * (axes[0] - 1);
  double const small = radius * (axes[1] - 1);
  double sum = 0;
  double hysteresis = 0;
  for (int i = 0; i < directions; ++i) {
    double const angle = 2 * std::numbers::pi * i / directions;
    double const deviation = deviation_at(angle, Sense::counterclockwise);
    sum += deviation;
    hysteresis = std::max(hysteresis, std::abs(deviation - deviation_at(angle, Sense::clockwise)));
  }
  return {.counterclockwise = large - small,
          .clockwise = large - small,
          .bidirectional = large - small,
          .mean_radial = sum / directions,
          .radial_max = large,
          .radial_min = small,
          .hysteresis = hysteresis};
}

}  // namespace axisc::circle
