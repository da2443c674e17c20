#include "validator/rules/step_overshoot.hpp"

#include "design/filter_analysis.hpp"
#include "validator/rules/filter_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace axisc::validator::says {

constexpr Sentence filter_overshoot{"a step overshoots by {overshoot} %",
                                    "ein Sprung schwingt um {overshoot} % über"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

// A thousand cycles per period: the peak between two samples is missed by less than 1e-5 of its height.
constexpr double lowest_measured = 1e-3;
constexpr double measured_periods = 20;

}  // namespace

std::optional<double> step_overshoot(FilterContext const& context) {
  auto const& specification = context.axis.designs.specification(context.filter);
  if (!specification) return std::nullopt;
  return step_overshoot(*specification, context.axis.cycle_time);
}

double step_overshoot(design::FilterSpecification specification, design::CycleTime cycle_time) {
  double const slowest = lowest_measured / cycle_time.seconds();
  specification.frequency.value = std::max(specification.frequency.value, slowest);
  std::array const chain{design::design_filter(specification, cycle_time, design::Precision::quick)};
  double const cycles_per_period = 1 / (specification.frequency.value * cycle_time.seconds());
  auto const longest = static_cast<std::uint64_t>(std::ceil(measured_periods * cycles_per_period)) + 1;
  return design::step_overshoot(chain, longest);
}

Message overshoot_label(double overshoot) {
  return {says::filter_overshoot, {{"overshoot", percent(overshoot)}}};
}

}  // namespace axisc::validator::checks
