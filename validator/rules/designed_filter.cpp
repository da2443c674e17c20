#include "validator/rules/designed_filter.hpp"

#include "design/filter_analysis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace axisc::validator::checks {
namespace {

// A thousand cycles per period: the peak between two samples is missed by less than 1e-5 of its height.
constexpr double lowest_measured = 1e-3;
constexpr double measured_periods = 20;
constexpr double settled = 1e-4;

}  // namespace

std::optional<design::FilterDesign> designed(FilterView const& filter, design::CycleTime cycle_time) {
  auto const specification = filter.specification(cycle_time);
  if (!specification) return std::nullopt;
  return design::design_filter(*specification, cycle_time, design::Precision::quick);
}

std::optional<double> step_overshoot(FilterView const& filter, design::CycleTime cycle_time) {
  auto specification = filter.specification(cycle_time);
  if (!specification) return std::nullopt;
  double const slowest = lowest_measured / cycle_time.seconds();
  specification->frequency = {std::max(specification->frequency.value, slowest)};
  std::array const chain{design::design_filter(*specification, cycle_time, design::Precision::quick)};
  double const cycles_per_period = 1 / (specification->frequency.value * cycle_time.seconds());
  auto const longest = static_cast<std::uint64_t>(std::ceil(measured_periods * cycles_per_period)) + 1;
  return design::step_figures(chain, longest, settled).overshoot;
}

std::vector<ChainLink> setpoint_chain(EffectiveValues const& values, design::CycleTime cycle_time) {
  std::vector<ChainLink> chain;
  for (FilterView const& filter : touched_filters(values)) {
    if (filter.port != FilterPort::setpoint) continue;
    // Whether such a filter belongs to the chain is not known.
    if (filter.unusable()) return {};
    // With share 0 the signal passes by the filter.
    if (!filter.active() || filter.share.value.number == 0) continue;
    auto design = designed(filter, cycle_time);
    if (!design) return {};
    chain.push_back({filter, *std::move(design)});
  }
  return chain;
}

std::vector<design::FilterDesign> designs(std::vector<ChainLink> const& chain) {
  std::vector<design::FilterDesign> filters;
  filters.reserve(chain.size());
  for (ChainLink const& link : chain) filters.push_back(link.design);
  return filters;
}

}  // namespace axisc::validator::checks
