#include "analysis/tuning/rigid_model/rigid_model.hpp"

#include "analysis/tuning/rigid_model/model_fit.hpp"
#include "analysis/tuning/rigid_model/thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace axisc::tuning {

namespace {

/// The fits of one form, one for each length.
struct Fits {
  bool is_coarse = false;  ///< no window is long enough
  std::vector<ModelFit> fits;

  /// With the narrowest mass. There must be one.
  [[nodiscard]] ModelFit const& best() const {
    auto const width = [](ModelFit const& fit) {
      return fit.half_widths[Term::mass] / std::abs(fit.values[Term::mass]);
    };
    return *std::min_element(fits.begin(), fits.end(),
                             [&](ModelFit const& a, ModelFit const& b) { return width(a) < width(b); });
  }
  /// Half of the spread over the lengths.
  [[nodiscard]] double spread(std::size_t term) const {
    auto const [low, high] = std::minmax_element(
        fits.begin(), fits.end(),
        [term](ModelFit const& a, ModelFit const& b) { return a.values.at(term) < b.values.at(term); });
    return (high->values.at(term) - low->values.at(term)) / 2;
  }
};

/// What the form needs at its highest derivative must stand out from the noise.
std::optional<std::size_t> first_length(std::span<MotionRecord const> records, double noise, double T,
                                        ModelForm form) {
  constexpr double step = 1.1;
  bool const is_elastic = form == ModelForm::elastic;
  double const seconds = is_elastic ? longest_first_elastic_window : longest_first_window;
  auto const longest = static_cast<std::size_t>(std::lround(seconds / T));
  for (std::size_t length = shortest_window; length <= std::max(longest, shortest_window);
       length =
           std::max(length + 1, static_cast<std::size_t>(std::lround(step * static_cast<double>(length))))) {
    auto const window = make_window(length, T);
    auto const& weights = is_elastic ? window.fourth : window.acceleration;
    if (noise_share(records, weights, noise) < largest_noise_share) return length;
  }
  return std::nullopt;
}

std::vector<std::size_t> lengths_from(std::size_t first, double T) {
  auto const low = static_cast<double>(first);
  double const high = std::max(longest_first_window / T, longest_window_ratio * low);
  std::vector<std::size_t> lengths;
  for (std::size_t i = 0; i < window_lengths; ++i) {
    double const share = static_cast<double>(i) / static_cast<double>(window_lengths - 1);
    auto const length = static_cast<std::size_t>(std::lround(low * std::pow(high / low, share)));
    if (lengths.empty() || length > lengths.back()) lengths.push_back(length);
  }
  return lengths;
}

Fits fits_of(std::span<MotionRecord const> records, Directions const& directions, double T, ModelForm form) {
  Fits found;
  auto const first = first_length(records, directions.noise(), T, form);
  if (!first) return {.is_coarse = true, .fits = {}};
  for (auto const length : lengths_from(*first, T)) {
    auto const window = make_window(length, T);
    auto const fit = fit_model(records, motion_windows(records, directions, window), window, form);
    if (fit) found.fits.push_back(*fit);
  }
  return found;
}

std::optional<RigidDoubt> doubt_of_motion(Directions const& directions, double T) {
  auto const forwards = static_cast<double>(directions.forwards()) * T;
  auto const backwards = static_cast<double>(directions.backwards()) * T;
  if (!(forwards + backwards > 0)) return RigidDoubt::no_motion;
  if (forwards + backwards < shortest_motion) return RigidDoubt::too_short;
  if (std::min(forwards, backwards) < shortest_direction) return RigidDoubt::one_direction;
  return std::nullopt;
}

Estimate estimate_of(Fits const& elastic, ModelFit const& rigid, Term::Index term) {
  auto const& best = elastic.best();
  double const value = best.values.at(term);
  double const random = interval_factor * best.half_widths.at(term);
  double const scatter = std::hypot(random, elastic.spread(term), model_uncertainty * value);
  return {.value = value, .uncertainty = std::hypot(scatter, value - rigid.values.at(term))};
}

std::optional<RigidDoubt> doubt_of(RigidModel const& model, Fits const& elastic, ModelFit const& rigid) {
  if (!(model.mass.value > 0)) return RigidDoubt::unexplained;
  if (model.accelerating < least_accelerating) return RigidDoubt::no_acceleration;
  if (model.explained < least_explained_force) return RigidDoubt::unexplained;
  if (model.mass.is_within(largest_mass_uncertainty)) return std::nullopt;
  double const random = interval_factor * elastic.best().half_widths[Term::mass];
  double const apart = std::abs(model.mass.value - rigid.values[Term::mass]);
  return apart > std::hypot(random, elastic.spread(Term::mass)) ? RigidDoubt::elastic : RigidDoubt::scattered;
}

}  // namespace

bool RigidModel::has_coulomb() const {
  return has_mass() && coulomb.is_within(largest_coulomb_uncertainty);
}

bool RigidModel::has_viscous() const {
  return has_mass() && viscous.is_within(largest_viscous_uncertainty);
}

RigidModel rigid_model_of(std::span<MotionRecord const> records, double T) {
  RigidModel model;
  Directions const directions(records, T);
  model.doubt = doubt_of_motion(directions, T);
  if (model.doubt) return model;
  auto const rigid = fits_of(records, directions, T, ModelForm::rigid);
  auto const elastic = fits_of(records, directions, T, ModelForm::elastic);
  if (rigid.fits.empty() || elastic.fits.empty()) {
    model.doubt = rigid.is_coarse || elastic.is_coarse ? RigidDoubt::coarse : RigidDoubt::too_short;
    return model;
  }
  auto const& best = elastic.best();
  auto const& other = rigid.best();
  model.mass = estimate_of(elastic, other, Term::mass);
  model.coulomb = estimate_of(elastic, other, Term::coulomb);
  model.viscous = estimate_of(elastic, other, Term::viscous);
  model.constant = estimate_of(elastic, other, Term::constant);
  model.explained = best.explained;
  model.accelerating = best.accelerating;
  model.dead_time = best.dead_time;
  model.length = best.length;
  model.windows = best.windows;
  model.doubt = doubt_of(model, elastic, other);
  return model;
}

}  // namespace axisc::tuning
