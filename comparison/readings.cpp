#include "comparison/readings.hpp"

#include "comparison/filter_readings.hpp"
#include "comparison/kernel_readings.hpp"
#include "design/filter_kinds.hpp"
#include "design/kernel_kinds.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::comparison::says {

constexpr Sentence double_cycle{"the filters are computed for twice the cycle time",
                                "die Filter sind für die doppelte Zykluszeit gerechnet"};
constexpr Sentence half_cycle{"the filters are computed for half the cycle time",
                              "die Filter sind für die halbe Zykluszeit gerechnet"};
constexpr Sentence fourfold_cycle{"the filters are computed for four times the cycle time",
                                  "die Filter sind für die vierfache Zykluszeit gerechnet"};
constexpr Sentence quarter_cycle{"the filters are computed for a quarter of the cycle time",
                                 "die Filter sind für ein Viertel der Zykluszeit gerechnet"};
constexpr Sentence filters_off{"the standard filters are off, as the default list has them",
                               "die Standardfilter sind aus, wie in der Standardliste"};
constexpr Sentence kernel_off{"the linear-phase filter is off", "der linearphasige Filter ist aus"};
constexpr Sentence kernel_on{"the linear-phase filter is on", "der linearphasige Filter ist an"};

}  // namespace axisc::comparison::says

namespace axisc::comparison {

namespace {

constexpr double same_number = 1e-12;

/// One part of the chain in one reading.
struct Part {
  std::optional<Departure> departure;
  Chain links;
};

bool same(std::vector<double> const& one, std::vector<double> const& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](double a, double b) { return std::abs(a - b) < same_number; });
}

bool same(Chain const& one, Chain const& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](Link const& a, Link const& b) {
    return a.sections == b.sections && a.share == b.share && same(a.taps, b.taps);
  });
}

/// Whether the answers to a jump are the same but for whole cycles, which no recording tells apart from an offset of its columns.
bool same_but_delayed(Chain const& one, Chain const& other) {
  constexpr std::size_t jump = 8;  // also the longest delay
  constexpr double indistinguishable = 3e-5;
  std::size_t const length = std::max(settling_cycles(one), settling_cycles(other)) + 2 * jump;
  std::vector<double> step(length, 1.0);
  std::fill_n(step.begin(), jump, 0.0);
  auto const a = respond(one, step);
  auto const b = respond(other, step);
  auto const agree = [&](std::size_t later_a, std::size_t later_b) {
    for (std::size_t n = jump; n + jump < length; ++n) {
      if (std::abs(a[n + later_a] - b[n + later_b]) > indistinguishable) return false;
    }
    return true;
  };
  for (std::size_t delay = 0; delay < jump; ++delay) {
    if (agree(0, delay) || agree(delay, 0)) return true;
  }
  return false;
}

void add(std::vector<Part>& parts, Part part) {
  for (auto const& known : parts) {
    if (same(known.links, part.links) || same_but_delayed(known.links, part.links)) return;
  }
  parts.push_back(std::move(part));
}

bool can_be_designed(design::FilterSpecification const& filter, design::CycleTime cycle_time) {
  return !design::uses_frequency(filter.type) || filter.frequency < cycle_time.nyquist();
}

Chain listed_filters(Configured const& configured, design::CycleTime cycle_time) {
  Chain chain;
  for (auto const& filter : configured.filters) {
    if (!can_be_designed(filter, cycle_time)) return {};
    chain.push_back(link_of(design::design_filter(filter, cycle_time, design::Precision::quick)));
  }
  return chain;
}

std::vector<Part> filter_parts(Configured const& configured) {
  std::vector<Part> parts{{std::nullopt, listed_filters(configured, configured.cycle_time)}};
  for (auto const& reading : filter_readings()) {
    Chain chain = parts.front().links;
    bool changed = false;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      auto link = reading.link(configured.filters[i], configured.cycle_time);
      if (!link) continue;
      chain[i] = *std::move(link);
      changed = true;
    }
    if (changed) add(parts, {reading.departure, std::move(chain)});
  }
  add(parts, {Departure{"filters-off", says::filters_off}, {}});
  return parts;
}

Chain kernel_chain(std::vector<double> taps) {
  return {Link{.taps = std::move(taps)}};
}

std::vector<Part> kernel_parts(Configured const& configured) {
  if (!configured.kernel) return {{std::nullopt, {}}};
  auto const listed = design::design_kernel(*configured.kernel, configured.cycle_time).taps;
  std::vector<Part> parts{{std::nullopt, configured.kernel_on ? kernel_chain(listed) : Chain{}}};
  if (!configured.kernel_on) {
    add(parts, {Departure{"filter-on", says::kernel_on}, kernel_chain(listed)});
    return parts;
  }
  for (auto const& reading : kernel_readings()) {
    auto taps = reading.taps(*configured.kernel, configured.cycle_time);
    if (!taps.empty()) add(parts, {reading.departure, kernel_chain(std::move(taps))});
  }
  add(parts, {Departure{"filter-off", says::kernel_off}, {}});
  return parts;
}

Reading joined(Part const& filters, Part const& kernel) {
  Reading reading{.departures = {}, .chain = filters.links};
  reading.chain.insert(reading.chain.end(), kernel.links.begin(), kernel.links.end());
  for (auto const* part : {&filters, &kernel}) {
    if (part->departure) reading.departures.push_back(*part->departure);
  }
  return reading;
}

/// All parts but delays of whole cycles know the cycle time.
void add_other_cycle_time(std::vector<Reading>& all, Configured const& configured, Departure departure,
                          double factor) {
  design::CycleTime const other{
      static_cast<std::uint32_t>(std::lround(configured.cycle_time.nanoseconds * factor))};
  Chain chain = listed_filters(configured, other);
  if (chain.size() != configured.filters.size()) return;
  if (configured.kernel && configured.kernel_on) {
    auto const& kernel = *configured.kernel;
    auto const& kind = design::kind_of(kernel.type);
    bool const fits = !kind.uses_frequency || kernel.frequency < other.nyquist();
    bool const is_short = !kind.computes_order || kernel.frequency >= design::lowest_novib_frequency(other);
    if (!fits || !is_short) return;
    chain.push_back(kernel_chain(design::design_kernel(kernel, other).taps).front());
  }
  if (!same(chain, all.front().chain)) all.push_back({{departure}, std::move(chain)});
}

}  // namespace

std::vector<Reading> readings(Configured const& configured) {
  auto const filters = filter_parts(configured);
  auto const kernels = kernel_parts(configured);
  std::vector<Reading> all;
  for (auto const& filter : filters) {
    for (auto const& kernel : kernels) all.push_back(joined(filter, kernel));
  }
  add_other_cycle_time(all, configured, {"cycle-time-double", says::double_cycle}, 2);
  add_other_cycle_time(all, configured, {"cycle-time-half", says::half_cycle}, 0.5);
  add_other_cycle_time(all, configured, {"cycle-time-fourfold", says::fourfold_cycle}, 4);
  add_other_cycle_time(all, configured, {"cycle-time-quarter", says::quarter_cycle}, 0.25);
  std::stable_sort(all.begin(), all.end(), [](Reading const& a, Reading const& b) {
    return a.departures.size() < b.departures.size();
  });
  return all;
}

}  // namespace axisc::comparison
