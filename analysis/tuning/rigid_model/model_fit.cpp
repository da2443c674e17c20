#include "analysis/tuning/rigid_model/model_fit.hpp"

#include "analysis/motion/least_squares.hpp"
#include "analysis/motion/statistics.hpp"
#include "analysis/tuning/rigid_model/thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace axisc::tuning {

namespace {

using Sums = motion::LeastSquares<model_terms>;

double dot(ModelValues const& row, ModelValues const& values) {
  double sum = 0;
  for (std::size_t i = 0; i < model_terms; ++i) sum += row.at(i) * values.at(i);
  return sum;
}

/// Where a friction would be negative it is 0.
std::optional<ModelValues> solve(Sums const& sums, ModelForm form) {
  auto const without = [&](std::initializer_list<Term::Index> terms) {
    auto reduced = sums;
    if (form == ModelForm::rigid) reduced.leave_out(Term::elastic);
    for (auto const term : terms) reduced.leave_out(term);
    return reduced.solve();
  };
  auto found = without({});
  for (auto const [one, other] :
       {std::array{Term::viscous, Term::coulomb}, std::array{Term::coulomb, Term::viscous}}) {
    if (!found || !(found->at(one) < 0)) continue;
    found = without({one});
    if (found && found->at(other) < 0) return without({Term::viscous, Term::coulomb});
    return found;
  }
  return found;
}

class Fitter {
 public:
  Fitter(std::span<MotionRecord const> records, std::vector<WindowMotion> const& motion, Window const& window,
         ModelForm form)
      : records_(records), motion_(motion), window_(window), form_(form) {
    for (auto const& one : motion) {
      rows_.push_back({one.acceleration, one.velocity, static_cast<double>(one.direction), 1.0, one.fourth});
    }
    scale();
  }

  std::optional<ModelFit> fit() {
    double least = std::numeric_limits<double>::infinity();
    for (int dead_time = earliest_force; dead_time <= latest_force; ++dead_time) {
      auto trial = weighted(dead_time);
      if (!trial || !(trial->residual < least)) continue;
      least = trial->residual;
      best_ = std::move(*trial);
    }
    if (!std::isfinite(least)) return std::nullopt;
    ModelFit found{.dead_time = best_.dead_time, .length = window_.length(), .windows = motion_.size()};
    found.values = unscaled(best_.values);
    auto const blocks = block_sums();
    found.half_widths = unscaled(half_widths(blocks));
    double const force_variance = motion::variance(best_.forces);
    found.explained = std::min(explained(0), explained(1));
    std::vector<double> accelerating;
    for (auto const& one : motion_) accelerating.push_back(found.values[Term::mass] * one.acceleration);
    if (force_variance > 0) found.accelerating = std::sqrt(motion::variance(accelerating) / force_variance);
    return found;
  }

 private:
  struct Trial {
    int dead_time = 0;
    std::vector<double> forces, weights;  ///< by window
    ModelValues values{};                 ///< of scaled rows
    double residual = 0;                  ///< median of the absolute values
  };

  /// Entries of about 1.
  void scale() {
    for (std::size_t i = 0; i < model_terms; ++i) {
      double sum = 0;
      for (auto const& row : rows_) sum += row.at(i) * row.at(i);
      double const size = std::sqrt(sum / static_cast<double>(rows_.size()));
      if (size > 0) scale_.at(i) = size;
      for (auto& row : rows_) row.at(i) /= scale_.at(i);
    }
  }

  [[nodiscard]] ModelValues unscaled(ModelValues values) const {
    for (std::size_t i = 0; i < model_terms; ++i) values.at(i) /= scale_.at(i);
    return values;
  }

  [[nodiscard]] std::optional<Trial> weighted(int dead_time) const {
    constexpr int iterations = 6;
    constexpr double deviation_of_median = 1.4826;
    Trial trial{.dead_time = dead_time, .forces = {}, .weights = std::vector<double>(rows_.size(), 1.0)};
    for (auto const& one : motion_) {
      trial.forces.push_back(window_force(records_[one.record], one.first, dead_time, window_));
    }
    double const smallest = 1e-9 * std::sqrt(motion::variance(trial.forces));
    for (int i = 0; i < iterations; ++i) {
      Sums sums;
      for (std::size_t k = 0; k < rows_.size(); ++k) add(sums, trial, k);
      auto const values = solve(sums, form_);
      if (!values) return std::nullopt;
      trial.values = *values;
      std::vector<double> residuals;
      for (std::size_t k = 0; k < rows_.size(); ++k) {
        residuals.push_back(std::abs(trial.forces[k] - dot(rows_[k], trial.values)));
      }
      trial.residual = motion::median(residuals);
      double const width = huber_width * std::max(smallest, deviation_of_median * trial.residual);
      for (std::size_t k = 0; k < rows_.size(); ++k) {
        trial.weights[k] = residuals[k] > width ? width / residuals[k] : 1;
      }
    }
    return trial;
  }

  void add(Sums& sums, Trial const& trial, std::size_t k) const {
    sums.add(rows_[k], trial.forces[k], trial.weights[k] / static_cast<double>(rows_.size()));
  }

  [[nodiscard]] std::size_t block_count() const {
    return std::clamp(rows_.size() / windows_per_block, fewest_blocks, most_blocks);
  }
  [[nodiscard]] std::size_t block_of(std::size_t k) const { return k * block_count() / rows_.size(); }

  [[nodiscard]] std::vector<Sums> block_sums() const {
    std::vector<Sums> blocks(block_count());
    for (std::size_t k = 0; k < rows_.size(); ++k) add(blocks[block_of(k)], best_, k);
    return blocks;
  }

  [[nodiscard]] ModelValues half_widths(std::vector<Sums> const& blocks) const {
    std::mt19937 random(bootstrap_seed);
    std::array<std::vector<double>, model_terms> samples;
    for (std::size_t n = 0; n < resamplings; ++n) {
      Sums sums;
      for (std::size_t i = 0; i < blocks.size(); ++i) sums.add(blocks[random() % blocks.size()]);
      auto const values = solve(sums, form_);
      if (!values) continue;
      for (std::size_t i = 0; i < model_terms; ++i) samples.at(i).push_back(values->at(i));
    }
    ModelValues found{};
    for (std::size_t i = 0; i < model_terms; ++i) {
      auto& sample = samples.at(i);
      std::sort(sample.begin(), sample.end());
      constexpr std::size_t beyond = 40;  // 2.5 % on either side
      auto const left_out = sample.size() / beyond;
      bool const is_known = sample.size() > resamplings / 2;
      found.at(i) = is_known ? (sample[sample.size() - 1 - left_out] - sample[left_out]) / 2
                             : std::numeric_limits<double>::infinity();
    }
    return found;
  }

  /// Of the force of every other window, by the fit to those between them.
  [[nodiscard]] double explained(std::size_t fitted) const {
    auto const is_fitted = [fitted](std::size_t k) { return k % 2 == fitted; };
    Sums sums;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (is_fitted(k)) add(sums, best_, k);
    }
    auto const values = solve(sums, form_);
    if (!values) return 0;
    std::vector<double> forces;
    double left = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (is_fitted(k)) continue;
      double const residual = best_.forces[k] - dot(rows_[k], *values);
      left += residual * residual;
      forces.push_back(best_.forces[k]);
    }
    double const whole = motion::variance(forces) * static_cast<double>(forces.size());
    return whole > 0 ? 1 - left / whole : 0;
  }

  std::span<MotionRecord const> records_;
  std::vector<WindowMotion> const& motion_;
  Window const& window_;
  ModelForm form_;
  std::vector<ModelValues> rows_;
  ModelValues scale_{1, 1, 1, 1, 1};
  Trial best_;
};

}  // namespace

std::optional<ModelFit> fit_model(std::span<MotionRecord const> records,
                                  std::vector<WindowMotion> const& motion, Window const& window,
                                  ModelForm form) {
  auto const forwards = static_cast<std::size_t>(
      std::count_if(motion.begin(), motion.end(), [](WindowMotion const& one) { return one.direction > 0; }));
  auto const fewer = std::min(forwards, motion.size() - forwards);
  if (motion.size() < fewest_blocks * windows_per_block || fewer < fewest_windows_of_direction) {
    return std::nullopt;
  }
  return Fitter(records, motion, window, form).fit();
}

}  // namespace axisc::tuning
