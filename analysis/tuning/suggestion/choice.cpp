#include "analysis/tuning/suggestion/choice.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

namespace axisc::tuning {
namespace {

/// A difference below this is not worth a larger deviation.
constexpr double no_vibration = 5e-4;

double price(Figures const& figures, std::optional<Goal> goal) {
  return goal == Goal::speed ? figures.delay : figures.corner;
}

/// The cheapest candidate, clean or not, of those that leave at most `limit`; settled. Of equals the first.
template <class Price>
Candidate* cheapest(std::span<Candidate> candidates, Judge const& judge, bool is_clean, double limit,
                    Price const& price_of) {
  struct Entry {
    double price;
    std::size_t index;
    bool operator>(Entry const& other) const {
      return price != other.price ? price > other.price : index > other.index;
    }
  };
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  auto const add = [&](std::size_t index) {
    auto const& candidate = candidates[index];
    if (candidate.is_clean != is_clean || candidate.figures.vibration > limit) return;
    queue.push({price_of(candidate.figures), index});
  };
  for (std::size_t i = 0; i < candidates.size(); ++i) add(i);
  while (!queue.empty()) {
    auto const index = queue.top().index;
    auto& candidate = candidates[index];
    if (candidate.is_settled) return &candidate;
    queue.pop();
    refine(candidate, judge);
    add(index);
  }
  return nullptr;
}

double vibration_of(Figures const& figures) {
  return figures.vibration;
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

std::optional<Choice> choose(std::span<Candidate> candidates, Judge const& judge, std::optional<Goal> goal) {
  auto const price_of = [&](Figures const& figures) { return price(figures, goal); };
  auto const balance_of = [&](Figures const& figures) { return balance(figures, goal); };
  auto const best = [&](double limit, auto const& of) {
    return cheapest(candidates, judge, true, limit, of);
  };
  auto const* const calmest = best(useful_vibration, vibration_of);
  if (calmest == nullptr) return std::nullopt;
  double const same = calmest->figures.vibration + no_vibration;
  double const sufficient = std::max(sufficient_vibration, same);
  auto const* const balanced = best(sufficient, balance_of);
  Choice choice{.chosen = {*best(sufficient, price_of), *balanced, *best(same, price_of)},
                .recommended = recommended(goal)};
  auto const* const not_clean = cheapest(candidates, judge, false, sufficient, balance_of);
  if (not_clean != nullptr && balance_of(not_clean->figures) < balance_of(balanced->figures)) {
    choice.not_clean = *not_clean;
  }
  return choice;
}

double least_vibration(std::span<Candidate> candidates, Judge const& judge) {
  auto const* const calmest =
      cheapest(candidates, judge, true, std::numeric_limits<double>::infinity(), vibration_of);
  return calmest == nullptr ? 1 : calmest->figures.vibration;
}

}  // namespace axisc::tuning
