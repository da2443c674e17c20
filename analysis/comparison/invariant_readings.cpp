#include "analysis/comparison/invariant_readings.hpp"

#include "design/filter_kinds.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace axisc::comparison::says {

constexpr Sentence impulse_invariant{"impulse-invariant", "impulsinvariant"};
constexpr Sentence step_invariant{"step-invariant (zero-order hold)",
                                  "sprunginvariant (Halteglied nullter Ordnung)"};

}  // namespace axisc::comparison::says

namespace axisc::comparison {

namespace {

using design::CycleTime;
using design::FilterSpecification;
using design::FilterType;
using Result = std::optional<Link>;

Link designed(FilterSpecification wanted, CycleTime cycle_time) {
  wanted.reading = design::FilterReading::documented;
  return link_of(design::design_filter(wanted, cycle_time, design::Precision::quick));
}

bool is_lag(FilterSpecification const& wanted) {
  return wanted.type == FilterType::lowpass || wanted.type == FilterType::pt1 ||
         wanted.type == FilterType::pt2;
}

constexpr std::size_t parts_of_cycle = 64;

/// The analogue filter's answer to a step, in parts of a cycle. The bilinear transform of a short cycle turns
/// the jump into a ramp between two samples, so that these lag by half a part.
std::vector<double> analogue_step(FilterSpecification wanted, CycleTime cycle_time) {
  wanted.share_percent = 100;
  auto const link = designed(wanted, CycleTime{cycle_time.nanoseconds / std::uint32_t{parts_of_cycle}});
  constexpr std::size_t longest = 4000;
  std::size_t const cycles = std::min(longest, settling_cycles({designed(wanted, cycle_time)}) + 4);
  std::vector<double> step(cycles * parts_of_cycle + 1, 1.0);
  step.front() = 0;
  auto answer = respond({link}, step);
  answer.erase(answer.begin());
  return answer;
}

/// Taps that sum up to the share; the rest passes through.
Link with_share(std::vector<double> taps, double share_percent) {
  double const sum = std::accumulate(taps.begin(), taps.end(), 0.0);
  for (double& tap : taps) tap *= share_percent / 100 / sum;
  taps.front() += 1 - share_percent / 100;
  return {.taps = std::move(taps)};
}

Result by_impulse(FilterSpecification const& wanted, CycleTime cycle_time) {
  if (!is_lag(wanted)) return std::nullopt;
  auto const step = analogue_step(wanted, cycle_time);
  auto const slope = [&](std::size_t at) { return step[at] - step[at - 1]; };
  std::vector<double> taps{3 * slope(1) - 3 * slope(2) + slope(3)};
  for (std::size_t at = parts_of_cycle; at < step.size(); at += parts_of_cycle) taps.push_back(slope(at));
  return with_share(std::move(taps), wanted.share_percent);
}

Result by_step(FilterSpecification const& wanted, CycleTime cycle_time) {
  if (!is_lag(wanted)) return std::nullopt;
  auto const step = analogue_step(wanted, cycle_time);
  std::vector<double> taps{0.0};
  double last = 0;
  for (std::size_t at = parts_of_cycle; at < step.size(); at += parts_of_cycle) {
    double const here = (step[at] + step[at - 1]) / 2;
    taps.push_back(here - last);
    last = here;
  }
  return with_share(std::move(taps), wanted.share_percent);
}

constexpr std::array<FilterReading, 2> invariant_rows{
    {{{"impulse-invariant", says::impulse_invariant}, by_impulse},
     {{"step-invariant", says::step_invariant}, by_step}}};

}  // namespace

std::span<FilterReading const> invariant_readings() {
  return invariant_rows;
}

}  // namespace axisc::comparison
