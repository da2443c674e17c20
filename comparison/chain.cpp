#include "comparison/chain.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::comparison {

namespace {

constexpr std::size_t longest_settling = 20000;
constexpr double settled = 1e-6;

/// The runtime's recursion on increments (see design/filter_design.hpp).
void run_sections(Link const& link, std::vector<double>& signal) {
  struct State {
    double e = 0, r = 0;
  };
  std::vector<State> states(link.sections.size());
  double sum = 0;
  double last = signal.front();
  double passed = 0;  // what a blocking section has integrated
  for (double& x : signal) {
    double d = x - last;
    last = x;
    for (std::size_t i = 0; i < states.size(); ++i) {
      auto const& s = link.sections[i];
      auto& [e, r] = states[i];
      double const change = s.p * d + r;
      e += change;
      r = change + s.q * d - s.k * e - s.b * change;
      if (link.blocks_constant) {
        d = change;
        passed = e;
      } else {
        d += change;
        sum += change;
      }
    }
    double const filtered = link.blocks_constant ? passed : x + sum;
    x += link.share * (filtered - x);
  }
}

void run_taps(std::vector<double> const& taps, std::vector<double>& signal) {
  std::size_t const before = taps.size() - 1;
  std::vector<double> padded(before, signal.front());
  padded.insert(padded.end(), signal.begin(), signal.end());
  double const origin = signal.front();
  for (double& x : padded) x -= origin;
  for (std::size_t n = 0; n < signal.size(); ++n) {
    double sum = 0;
    for (std::size_t k = 0; k < taps.size(); ++k) sum += taps[k] * padded[n + before - k];
    signal[n] = origin + sum;
  }
}

}  // namespace

Link link_of(design::FilterDesign const& filter) {
  if (filter.realisation == design::Realisation::sections) {
    return {.sections = filter.sections,
            .blocks_constant = filter.blocks_constant,
            .share = filter.share.filtered};
  }
  Link link{.taps = std::vector<double>(filter.delay_cycles + 1, 0.0)};
  link.taps.back() = filter.share.filtered;
  link.taps.front() += filter.delay_cycles == 0 ? 1 - filter.share.filtered : filter.share.direct;
  return link;
}

std::vector<double> respond(Chain const& chain, std::span<double const> input) {
  std::vector<double> signal(input.begin(), input.end());
  if (signal.empty()) return signal;
  for (auto const& link : chain) {
    if (link.taps.empty()) {
      run_sections(link, signal);
    } else {
      run_taps(link.taps, signal);
    }
  }
  return signal;
}

std::size_t settling_cycles(Chain const& chain) {
  std::size_t cycles = 1;
  for (auto const& link : chain) {
    cycles += link.taps.size();
    for (auto const& section : link.sections) {
      auto const [one, other] = design::poles(section);
      double const radius = std::max(std::abs(one), std::abs(other));
      if (radius >= 1) return longest_settling;
      if (radius > 0) cycles += static_cast<std::size_t>(std::log(settled) / std::log(radius)) + 1;
      if (cycles > longest_settling) return longest_settling;
    }
  }
  return cycles;
}

}  // namespace axisc::comparison
