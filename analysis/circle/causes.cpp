#include "analysis/circle/causes.hpp"

#include "analysis/motion/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace axisc::circle {

namespace {

constexpr double quarter = std::numbers::pi / 2;
constexpr double before_reversal = 1 * degree;
constexpr double after_reversal = 10 * degree;
constexpr double long_after_reversal = 25 * degree;
constexpr double spike_window = 20 * degree;
constexpr double largest_change = 0.3;

enum Term : std::size_t { r0, a, b, g, q, d, b_u, b_v, terms };
using Coefficients = std::array<double, terms>;

/// A sample in polar form.
struct Place {
  double theta = 0, rho = 0;
  Coefficients row{};

  Place(Sample const& sample, double s, double radius)
      : theta(std::atan2(sample.v, sample.u)), rho(std::hypot(sample.u, sample.v) - radius) {
    double const cosine = std::cos(theta);
    double const sine = std::sin(theta);
    double const twice = 2 * sine * cosine;
    row = {1,
           cosine,
           sine,
           std::cos(2 * theta),
           twice,
           s * twice,
           s / 2 * std::copysign(1.0, sine) * cosine,
           -s / 2 * std::copysign(1.0, cosine) * sine};
  }
  [[nodiscard]] double residual(Coefficients const& model) const {
    double left = rho;
    for (std::size_t i = 0; i < terms; ++i) left -= model[i] * row[i];
    return left;
  }
  /// Since the last reversal, 0 to 90°.
  [[nodiscard]] double past(double s) const {
    double const angle = std::fmod(s * theta, quarter);
    return angle < 0 ? angle + quarter : angle;
  }
  /// Which reversal was the last one, of the four in the order of the angle: u+, v+, u-, v-.
  [[nodiscard]] std::size_t reversal(double s) const {
    auto const at = static_cast<int>(std::lround((theta - s * past(s)) / quarter));
    return static_cast<std::size_t>((at + 4) % 4);
  }
};

template <class Visit>
void for_each_place(std::span<Turn const> turns, double radius, Visit visit) {
  for (auto const& turn : turns) {
    double const s = sign_of(turn.sense);
    for (auto const& sample : turn.samples) visit(Place(sample, s, radius), s, sample.weight);
  }
}

bool is_outside(Place const& place, double s, double window) {
  double const past = place.past(s);
  return past >= window && past <= quarter - before_reversal;
}

std::optional<Coefficients> fitted(std::span<Turn const> turns, double radius, double window) {
  motion::LeastSquares<terms> squares;
  for_each_place(turns, radius, [&](Place const& place, double s, double weight) {
    if (is_outside(place, s, window)) squares.add(place.row, place.rho, weight);
  });
  return squares.solve();
}

}  // namespace

double Causes::largest_spike(std::size_t axis) const {
  double largest = 0;
  for (std::size_t i = axis; i < spikes.size(); i += 2) largest = std::max(largest, spikes.at(i));
  return largest;
}

std::optional<Causes> causes_of(std::span<Turn const> turns, double radius) {
  auto const model = fitted(turns, radius, after_reversal);
  auto const wider = fitted(turns, radius, long_after_reversal);
  if (!model || !wider) return std::nullopt;
  auto const& found = *model;
  Causes causes{
      .radius = found[r0],
      .centre = {found[a], found[b]},
      .gain_difference = 2 * found[g] / radius,
      .squareness = -2 * found[q] / radius,
      .delay_difference = std::asin(std::clamp(2 * found[d] / radius, -1.0, 1.0)),
      .backlash = {found[b_u], found[b_v]},
      .backlash_uncertainty = {std::abs((*wider)[b_u] - found[b_u]), std::abs((*wider)[b_v] - found[b_v])}};
  causes.is_separable = *std::max_element(causes.backlash_uncertainty.begin(),
                                          causes.backlash_uncertainty.end()) <= largest_change;
  double squares = 0;
  double weights = 0;
  for_each_place(turns, radius, [&](Place const& place, double s, double weight) {
    double const left = place.residual(found);
    if (is_outside(place, s, after_reversal)) {
      squares += weight * left * left;
      weights += weight;
    }
    if (place.past(s) > spike_window) return;
    auto& spike = causes.spikes.at(place.reversal(s) + (s > 0 ? 0 : 4));
    spike = std::max(spike, left);
  });
  causes.unexplained_rms = std::sqrt(squares / weights);
  return causes;
}

}  // namespace axisc::circle
