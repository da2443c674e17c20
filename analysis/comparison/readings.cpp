#include "analysis/comparison/readings.hpp"

#include "analysis/comparison/filter_readings.hpp"
#include "analysis/comparison/invariant_readings.hpp"
#include "analysis/comparison/kernel_readings.hpp"
#include "design/filter_kinds.hpp"
#include "design/kernels/kernel_kinds.hpp"

#include <algorithm>

namespace axisc::comparison::says {

constexpr Sentence double_cycle{"the filters are computed for twice the cycle time",
                                "die Filter sind für die doppelte Zykluszeit gerechnet"};
constexpr Sentence half_cycle{"the filters are computed for half the cycle time",
                              "die Filter sind für die halbe Zykluszeit gerechnet"};
constexpr Sentence nc_cycle{"the filters are computed for the NC cycle time",
                            "die Filter sind für die NC-Zykluszeit gerechnet"};
constexpr Sentence fourfold_cycle{"the filters are computed for four times the cycle time",
                                  "die Filter sind für die vierfache Zykluszeit gerechnet"};
constexpr Sentence quarter_cycle{"the filters are computed for a quarter of the cycle time",
                                 "die Filter sind für ein Viertel der Zykluszeit gerechnet"};
constexpr Sentence filters_off{"the standard filters are off, as the default list has them",
                               "die Standardfilter sind aus, wie in der Standardliste"};
constexpr Sentence kernel_off{"the linear-phase filter is off", "der linearphasige Filter ist aus"};
constexpr Sentence unswitched{"the #FILTER commands change nothing", "die #FILTER-Befehle ändern nichts"};
constexpr Sentence kernel_on{"the linear-phase filter is on", "der linearphasige Filter ist an"};

}  // namespace axisc::comparison::says

namespace axisc::comparison {

namespace {

constexpr double same_number = 1e-12;

/// One part of the chain in one reading.
struct Part {
  std::optional<Departure> departure;
  Chain links;
  std::vector<Departure> equals{};  ///< other departures with these links
};

bool same(std::vector<double> const& one, std::vector<double> const& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](double a, double b) { return std::abs(a - b) < same_number; });
}

bool same(Chain const& one, Chain const& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](Link const& a, Link const& b) {
    return a.sections == b.sections && a.share == b.share && same(a.taps, b.taps) &&
           std::equal(a.switches.begin(), a.switches.end(), b.switches.begin(), b.switches.end(),
                      [](Switch const& x, Switch const& y) { return same(x.taps, y.taps); });
  });
}

/// With the longest kernel that it is switched to, and without switches.
Chain unswitched(Chain chain) {
  for (auto& link : chain) {
    for (auto& one : link.switches) {
      if (one.taps.size() > link.taps.size()) link.taps = std::move(one.taps);
    }
    link.switches.clear();
  }
  return chain;
}

/// Whether the answers to a jump are the same but for whole cycles, which no recording tells apart from an
/// offset of its columns. The same, not similar: whether a recording tells similar ones apart depends on its
/// motion.
bool same_but_delayed(Chain const& switched_one, Chain const& switched_other) {
  Chain const one = unswitched(switched_one);
  Chain const other = unswitched(switched_other);
  constexpr std::size_t jump = 8;  // also the longest delay
  constexpr double rounding = 1e-10;
  std::size_t const length = std::max(settling_cycles(one), settling_cycles(other)) + 2 * jump;
  std::vector<double> step(length, 1.0);
  std::fill_n(step.begin(), jump, 0.0);
  auto const a = respond(one, step);
  auto const b = respond(other, step);
  auto const agree = [&](std::size_t later_a, std::size_t later_b) {
    // Compared from the start: before the later answer, the other one must be at rest, too.
    for (std::size_t n = 0; n + jump < length; ++n) {
      if (std::abs(a[n + later_a] - b[n + later_b]) > rounding) return false;
    }
    return true;
  };
  for (std::size_t delay = 0; delay < jump; ++delay) {
    if (agree(0, delay) || agree(delay, 0)) return true;
  }
  return false;
}

void add(std::vector<Part>& parts, Part part) {
  for (auto& known : parts) {
    if (!same(known.links, part.links) && !same_but_delayed(known.links, part.links)) continue;
    if (known.departure) known.equals.push_back(*part.departure);
    return;
  }
  parts.push_back(std::move(part));
}

/// Empty where one of them cannot be designed.
Chain listed_filters(Configured const& configured) {
  Chain chain;
  for (auto const& filter : configured.filters) {
    if (!design::is_in_range(filter, configured.cycle_time)) return {};
    chain.push_back(link_of(design::design_filter(filter, configured.cycle_time, design::Precision::quick)));
  }
  return chain;
}

std::vector<Part> filter_parts(Configured const& configured) {
  std::vector<Part> parts{{std::nullopt, listed_filters(configured)}};
  for (auto const& readings : {filter_readings(), invariant_readings()}) {
    for (auto const& reading : readings) {
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
  }
  add(parts, {Departure{"filters-off", says::filters_off}, {}});
  return parts;
}

std::vector<double> passing() {
  return {1.0};
}

/// The linear-phase filter and its switches, each kernel designed by `taps`; empty where one of them cannot
/// be.
template <class Taps>
Chain kernel_chain(Configured const& configured, Taps const& taps) {
  if (configured.switches.empty() && !configured.kernel_on) return {};
  Link link{.taps = configured.kernel && configured.kernel_on ? taps(*configured.kernel) : passing()};
  bool complete = !link.taps.empty();
  for (auto const& one : configured.switches) {
    link.switches.push_back({one.cycle, one.kernel ? taps(*one.kernel) : passing(), one.fade_cycles});
    complete = complete && !link.switches.back().taps.empty();
  }
  return complete ? Chain{std::move(link)} : Chain{};
}

Chain listed_kernel(Configured const& configured) {
  return kernel_chain(configured, [&](design::KernelSpecification const& kernel) {
    return design::design_kernel(kernel, configured.cycle_time).taps;
  });
}

std::vector<Part> kernel_parts(Configured const& configured) {
  if (!configured.kernel && configured.switches.empty()) return {{std::nullopt, {}}};
  std::vector<Part> parts{{std::nullopt, listed_kernel(configured)}};
  for (auto const& reading : kernel_readings()) {
    Chain links = kernel_chain(configured, [&](design::KernelSpecification const& kernel) {
      return reading.taps(kernel, configured.cycle_time);
    });
    if (!links.empty()) add(parts, {reading.departure, std::move(links)});
  }
  if (!configured.switches.empty()) {
    parts.push_back({Departure{"filter-unswitched", says::unswitched},
                     listed_kernel(steady(configured, configured.kernel_on && configured.kernel))});
  } else if (configured.kernel_on) {
    add(parts, {Departure{"filter-off", says::kernel_off}, {}});
  } else {
    add(parts, {Departure{"filter-on", says::kernel_on}, listed_kernel(steady(configured, true))});
  }
  return parts;
}

Reading joined(Part const& filters, Part const& kernel) {
  Reading reading{.departures = {}, .chain = filters.links};
  reading.chain.insert(reading.chain.end(), kernel.links.begin(), kernel.links.end());
  // Every departure of the one with every departure of the other; the first of them is the reading's own.
  std::vector<std::vector<Departure>> ways{{}};
  for (auto const* part : {&filters, &kernel}) {
    if (!part->departure) continue;
    std::vector<std::vector<Departure>> longer;
    for (auto const& way : ways) {
      longer.push_back(way);
      longer.back().push_back(*part->departure);
      for (auto const& other : part->equals) {
        longer.push_back(way);
        longer.back().push_back(other);
      }
    }
    ways = std::move(longer);
  }
  reading.departures = std::move(ways.front());
  reading.equals.assign(ways.begin() + 1, ways.end());
  return reading;
}

bool can_be_designed(design::KernelSpecification const& kernel, design::CycleTime cycle_time) {
  auto const& kind = design::kind_of(kernel.type);
  design::CycleTime const computed_for = design::as_read(cycle_time, kernel.cycle_time);
  bool const fits = !kind.uses_frequency || kernel.frequency < computed_for.nyquist();
  return fits && (!kind.computes_order || kernel.frequency >= design::lowest_novib_frequency(computed_for));
}

/// All parts but delays of whole cycles depend on the cycle time.
void add_other_cycle_time(std::vector<Reading>& all, Configured configured, Departure departure,
                          design::CycleReading reading) {
  for (auto& filter : configured.filters) filter.cycle_time = reading;
  Chain chain = listed_filters(configured);
  if (chain.size() != configured.filters.size()) return;
  auto const take_over = [&](std::optional<design::KernelSpecification>& kernel) {
    if (kernel) kernel->cycle_time = reading;
    return !kernel || can_be_designed(*kernel, configured.cycle_time);
  };
  if (!take_over(configured.kernel)) return;
  for (auto& one : configured.switches) {
    if (!take_over(one.kernel)) return;
  }
  if (configured.kernel || !configured.switches.empty()) {
    auto const links = listed_kernel(configured);
    chain.insert(chain.end(), links.begin(), links.end());
  }
  if (!same(chain, all.front().chain)) all.push_back({{departure}, std::move(chain)});
}

}  // namespace

Configured steady(Configured configured, bool on) {
  configured.switches.clear();
  configured.kernel_on = on;
  return configured;
}

std::vector<Reading> readings(Configured const& configured) {
  auto const filters = filter_parts(configured);
  auto const kernels = kernel_parts(configured);
  std::vector<Reading> all;
  for (auto const& filter : filters) {
    for (auto const& kernel : kernels) all.push_back(joined(filter, kernel));
  }
  using design::CycleReading;
  add_other_cycle_time(all, configured, {cycle_time_double, says::double_cycle}, CycleReading::twice);
  add_other_cycle_time(all, configured, {cycle_time_half, says::half_cycle}, CycleReading::half);
  add_other_cycle_time(all, configured, {cycle_time_fourfold, says::fourfold_cycle}, CycleReading::fourfold);
  add_other_cycle_time(all, configured, {cycle_time_quarter, says::quarter_cycle}, CycleReading::quarter);
  add_other_cycle_time(all, configured, {documented_cycle_time, says::nc_cycle}, CycleReading::documented);
  std::stable_sort(all.begin(), all.end(), [](Reading const& a, Reading const& b) {
    return a.departures.size() < b.departures.size();
  });
  return all;
}

}  // namespace axisc::comparison
