#include "axisc/answers/contour/delay_words.hpp"

#include <cmath>

namespace axisc::says {

constexpr Sentence early{
    "position {position}, velocity feedforward {velocity}: the velocity arrives {lead} before its position",
    "Position {position}, Geschwindigkeitsvorsteuerung {velocity}: Die Geschwindigkeit kommt {lead} früher "
    "an als ihre Position"};
constexpr Sentence late{
    "position {position}, velocity feedforward {velocity}: the velocity arrives {lead} after its position",
    "Position {position}, Geschwindigkeitsvorsteuerung {velocity}: Die Geschwindigkeit kommt {lead} später "
    "an als ihre Position"};
constexpr Sentence together{
    "position {position}, velocity feedforward {velocity}: both arrive together",
    "Position {position}, Geschwindigkeitsvorsteuerung {velocity}: Beide kommen gleichzeitig an"};
constexpr Sentence of_it_lag{"of the position {lag} are the lag, which arises in the controller",
                             "von der Position sind {lag} Nachlauf, der erst im Regler entsteht"};
constexpr Sentence sum_alone{"position {position}; the velocity is not fed forward",
                             "Position {position}; die Geschwindigkeit wird nicht vorgesteuert"};
constexpr Sentence ahead{"accelerating at the limit, the axis is {deviation} ahead",
                         "beim Beschleunigen an der Grenze eilt die Achse {deviation} voraus"};
constexpr Sentence behind{"accelerating at the limit, the axis is {deviation} behind",
                          "beim Beschleunigen an der Grenze eilt die Achse {deviation} nach"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;
using validator::DelayBudget;

namespace {

Words sums_of(DelayBudget const& budget, design::CycleTime cycle_time) {
  auto const position = delay_time(budget.position, cycle_time);
  if (!budget.feeds_velocity) return {says::sum_alone, {{"position", position}}};
  bool const is_together = std::abs(budget.lead()) <= delay_rounding;
  SentenceRef const ahead_or_behind = budget.lead() > 0 ? says::early : says::late;
  SentenceRef const text = is_together ? SentenceRef(says::together) : ahead_or_behind;
  std::vector<NamedValue> values{{"position", position},
                                 {"velocity", delay_time(budget.velocity, cycle_time)}};
  if (!is_together) values.push_back({"lead", delay_time(std::abs(budget.lead()), cycle_time)});
  return {text, std::move(values)};
}

}  // namespace

Quantity delay_time(double cycles, design::CycleTime cycle_time) {
  constexpr int digits = 4;
  return rounded(cycles * cycle_time.microseconds() / 1e3, Unit::millisecond, digits);
}

std::vector<Words> delay_words(validator::LoadedAxis const& axis, DelayBudget const& budget,
                               design::CycleTime cycle_time) {
  if (budget.items.empty()) return {};
  std::vector<Words> words{sums_of(budget, cycle_time)};
  if (budget.lag != 0 && budget.feeds_velocity) {
    words.emplace_back(says::of_it_lag, std::vector<NamedValue>{{"lag", delay_time(budget.lag, cycle_time)}});
  }
  if (!budget.feeds_velocity || std::abs(budget.lead()) <= delay_rounding) return words;
  if (auto const deviation = validator::deviation_of_lead(axis, budget.lead(), cycle_time)) {
    words.emplace_back(
        *deviation > 0 ? says::ahead : says::behind,
        std::vector<NamedValue>{{"deviation", rounded(std::abs(*deviation), Unit::micrometre, 4)}});
  }
  return words;
}

}  // namespace axisc
