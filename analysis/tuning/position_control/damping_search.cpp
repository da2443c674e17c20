#include "analysis/tuning/position_control/damping_search.hpp"

#include "analysis/tuning/position_control/loop_answer.hpp"
#include "analysis/tuning/position_control/loop_trials.hpp"
#include "analysis/tuning/position_control/stage_settings.hpp"
#include "analysis/tuning/position_control/whole_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace axisc::tuning {
namespace {

using machine::PositionControl;

/// Settings that are tried with other plants at a time.
constexpr std::size_t portion = 64;
struct Ranked {
  PositionControl control;
  double sum = 0;  ///< of shares; at first of the plant itself, which is never more
  double shift = 0;
};

bool leaves_less(Ranked const& one, Ranked const& other) {
  return one.sum < other.sum;
}

bool shifts_less(Ranked const& one, Ranked const& other) {
  return one.shift < other.shift;
}

using Portions = std::vector<std::span<Ranked const>>;

Portions portions_of(std::span<Ranked const> ranked) {
  Portions portions;
  while (!ranked.empty()) {
    portions.push_back(ranked.first(std::min(portion, ranked.size())));
    ranked = ranked.subspan(portions.back().size());
  }
  return portions;
}

class Search {
 public:
  explicit Search(LoopTask const& task)
      : task_(task),
        plants_(plants_of(task)),
        circle_frequency_(task.velocity / task.radius / (2 * std::numbers::pi * task.cycle_time.seconds())) {
    for (auto const& plant : plants_) trials_.emplace_back(task_, plant);
  }

  std::variant<Damping, NoDampingFound> run() && {
    auto const none = [&](NoDamping reason) {
      return NoDampingFound{.reason = reason, .looked_at = looked_at_};
    };
    if (std::any_of(trials_.begin(), trials_.end(),
                    [](LoopTrials const& trial) { return trial.diverges(); })) {
      return none(NoDamping::diverges);
    }
    Damping found;
    LoopAnswer const answer(task_.plant, task_.cycle_time);
    on_circle_ = answer.at(circle_frequency_);
    for (auto const& resonance : task_.resonances) {
      found.resonances.push_back({.is_in_plant = has_peak(answer, resonance.frequency, reach_of(resonance))});
    }
    auto const is_there = [](DampedResonance const& resonance) { return resonance.is_in_plant; };
    if (std::none_of(found.resonances.begin(), found.resonances.end(), is_there)) {
      return none(NoDamping::no_resonance);
    }
    for (std::size_t i = 0; i < task_.resonances.size(); ++i) {
      double worst = 0;
      for (auto const& trial : trials_) worst = std::max(worst, trial.swings()[i]);
      unfiltered_.push_back(worst);
    }
    for (std::size_t i = 0; i < unfiltered_.size(); ++i) {
      found.resonances[i].is_noticeable = unfiltered_[i] >= noticeable_swing;
    }
    auto const needs_stage = [](DampedResonance const& resonance) {
      return resonance.is_in_plant && resonance.is_noticeable;
    };
    if (std::none_of(found.resonances.begin(), found.resonances.end(), needs_stage)) {
      return none(NoDamping::still);
    }
    double sum = 0;
    for (auto const& resonance : found.resonances) {
      counts_.push_back(needs_stage(resonance));
      sum += counts_.back() ? 1 : 0;
    }
    PositionControl chosen{.stages = {}, .limit_factor = whole_velocity};
    for (std::size_t i = 0; i < task_.resonances.size(); ++i) {
      if (!counts_[i]) continue;
      auto best = best_with_stage(chosen, i, sum);
      if (!best) continue;
      chosen = std::move(best->control);
      sum = best->sum;
      found.resonances[i].stage = chosen.stages.back().index;
    }
    if (chosen.stages.empty()) return none(NoDamping::not_enough);
    chosen.limit_factor = limit_for(task_, plants_, chosen);
    found.control = std::move(chosen);
    found.looked_at = looked_at_;
    found.circle = shift_on_circle(found.control);
    measure(task_, plants_, found);
    return found;
  }

 private:
  /// The best setting with one more stage; `sum` is that of the shares without it.
  std::optional<Ranked> best_with_stage(PositionControl const& chosen, std::size_t resonance, double sum) {
    auto ranked = nominal(chosen, resonance, sum - useful_share);
    if (!task_.least_vibration) {
      auto found = least_shift(ranked, sum - sufficient_share);
      if (found) return found;
    }
    return least_vibration(ranked, sum - useful_share);
  }

  [[nodiscard]] std::optional<Ranked> least_shift(std::vector<Ranked> ranked, double limit) const {
    std::erase_if(ranked, [limit](Ranked const& candidate) { return candidate.sum > limit; });
    std::sort(ranked.begin(), ranked.end(), shifts_less);
    for (auto const& part : portions_of(ranked)) {
      auto robust = worst_cases(part, limit);
      for (auto& candidate : robust) {
        if (keeps_margin(task_, plants_, candidate.control)) return std::move(candidate);
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Ranked> least_vibration(std::vector<Ranked>& ranked, double limit) const {
    std::sort(ranked.begin(), ranked.end(), leaves_less);
    std::optional<Ranked> best;
    for (auto const& part : portions_of(ranked)) {
      // The worst case is never less than that of the plant itself.
      if (part.front().sum >= limit) break;
      auto robust = worst_cases(part, limit);
      std::sort(robust.begin(), robust.end(), leaves_less);
      for (auto& candidate : robust) {
        if (!keeps_margin(task_, plants_, candidate.control)) continue;
        limit = candidate.sum;
        best = std::move(candidate);
        break;
      }
    }
    return best;
  }

  /// With the plant itself: those that leave no more than `limit`.
  std::vector<Ranked> nominal(PositionControl const& chosen, std::size_t resonance, double limit) {
    auto const index = static_cast<std::uint32_t>(chosen.stages.size());
    auto stages = stages_for(task_.resonances[resonance].frequency, index, task_.cycle_time);
    std::erase_if(stages, [&](machine::PositionControlStage const& stage) {
      return std::any_of(chosen.stages.begin(), chosen.stages.end(),
                         [&](auto const& other) { return !are_apart(stage, other); });
    });
    std::vector<Ranked> found;
    for (double const numerator : weight_numerators) {
      std::vector<PositionControl> controls;
      std::vector<machine::PositionControlStage> left;
      for (auto& stage : stages) {
        stage.weight_numerator = numerator;
        auto control = chosen;
        control.stages.push_back(stage);
        ++looked_at_;
        if (shift_on_circle(control) <= task_.tolerance) controls.push_back(std::move(control));
      }
      auto const tried = trials_.front().with(controls);
      for (std::size_t i = 0; i < tried.size(); ++i) {
        if (tried[i].grows) continue;
        left.push_back(controls[i].stages.back());
        double const sum = sum_of(tried[i].swings);
        double const enough = (1 - useful_share) * trials_.front().swings()[resonance];
        if (sum > limit || tried[i].swings[resonance] > enough) continue;
        found.push_back({.control = std::move(controls[i]), .sum = sum, .shift = tried[i].shift});
      }
      stages = std::move(left);
    }
    return found;
  }

  /// Settings that stay stable with each plant, also with twice the weights, in their order.
  std::vector<Ranked> worst_cases(std::span<Ranked const> candidates, double limit) const {
    std::vector<PositionControl> controls;
    for (auto const& candidate : candidates) {
      controls.push_back(candidate.control);
      controls.push_back(with_doubled_weights(candidate.control));
    }
    std::vector<std::vector<double>> worst(candidates.size(), std::vector<double>(task_.resonances.size()));
    std::vector<char> grows(candidates.size(), 0);
    for (auto const& trial : trials_) {
      auto const tried = trial.with(controls);
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (tried[2 * i].grows || tried[2 * i + 1].grows) {
          grows[i] = 1;
          continue;
        }
        for (std::size_t k = 0; k < worst[i].size(); ++k) {
          worst[i][k] = std::max(worst[i][k], tried[2 * i].swings[k]);
        }
      }
    }
    std::vector<Ranked> found;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      double const sum = sum_of(worst[i]);
      if (grows[i] != 0 || sum > limit) continue;
      found.push_back({.control = candidates[i].control, .sum = sum, .shift = candidates[i].shift});
    }
    return found;
  }

  [[nodiscard]] double shift_on_circle(PositionControl const& control) const {
    return task_.radius * shift_at(on_circle_, circle_frequency_, control, task_.cycle_time);
  }

  [[nodiscard]] double sum_of(std::vector<double> const& swings) const {
    double sum = 0;
    for (std::size_t i = 0; i < swings.size(); ++i) sum += counts_[i] ? swings[i] / unfiltered_[i] : 0;
    return sum;
  }

  LoopTask const& task_;
  std::vector<motion::PlantParameters> plants_;
  std::vector<LoopTrials> trials_;  ///< one for each plant
  std::vector<double> unfiltered_;  ///< worst case of each resonance without function
  std::vector<bool> counts_;        ///< resonances that may get a stage
  double circle_frequency_;         ///< Hz
  AnswerAt on_circle_;
  std::size_t looked_at_ = 0;
};

}  // namespace

std::variant<Damping, NoDampingFound> damp(LoopTask const& task) {
  return Search(task).run();
}

}  // namespace axisc::tuning
