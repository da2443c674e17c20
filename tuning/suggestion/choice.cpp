#include "tuning/suggestion/choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axisc::tuning {
namespace {

/// A difference below this is not worth a larger deviation.
constexpr double no_vibration = 5e-4;

double price(Figures const& figures, std::optional<Goal> goal) {
  return goal == Goal::speed ? figures.delay : figures.corner;
}

/// The cheapest of those that leave at most `limit`.
template <class Price>
Candidate const* cheapest(std::span<Candidate const> candidates, double limit, Price const& price_of) {
  Candidate const* best = nullptr;
  double lowest = std::numeric_limits<double>::infinity();
  for (auto const& candidate : candidates) {
    if (!candidate.is_clean || candidate.figures.vibration > limit) continue;
    double const here = price_of(candidate.figures);
    if (here < lowest) {
      lowest = here;
      best = &candidate;
    }
  }
  return best;
}

Sense recommended(std::optional<Goal> goal) {
  if (goal == Goal::surface) return Sense::least_vibration;
  if (goal == Goal::accuracy) return Sense::least_deviation;
  return Sense::balanced;
}

}  // namespace

double balance(Figures const& figures, std::optional<Goal> goal) {
  double const v = figures.vibration;
  return price(figures, goal) * (std::pow(v, 1.5) + 0.2 * v + 0.01);
}

std::optional<Choice> choose(std::span<Candidate const> candidates, std::optional<Goal> goal) {
  auto const price_of = [&](Figures const& figures) { return price(figures, goal); };
  auto const balance_of = [&](Figures const& figures) { return balance(figures, goal); };
  auto const* const calmest =
      cheapest(candidates, useful_vibration, [](Figures const& figures) { return figures.vibration; });
  if (calmest == nullptr) return std::nullopt;
  double const least = calmest->figures.vibration;
  double const same = least + no_vibration;
  double const sufficient = std::max(sufficient_vibration, same);
  auto const* const balanced = cheapest(candidates, sufficient, balance_of);
  Choice choice{.chosen = {*cheapest(candidates, sufficient, price_of), *balanced,
                           *cheapest(candidates, same, price_of)},
                .recommended = recommended(goal)};
  double lowest = balance_of(balanced->figures);
  for (auto const& candidate : candidates) {
    if (candidate.is_clean || candidate.figures.vibration > sufficient) continue;
    if (balance_of(candidate.figures) >= lowest) continue;
    lowest = balance_of(candidate.figures);
    choice.not_clean = candidate;
  }
  return choice;
}

}  // namespace axisc::tuning
