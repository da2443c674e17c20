#include "comparison/chain.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::comparison {

namespace {

constexpr std::size_t longest_settling = 20000;
constexpr double settled = 1e-6;

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

Runner::Runner(Chain chain) : chain_(std::move(chain)), memories_(chain_.size()) {}

/// The runtime's recursion on increments (see design/filter_design.hpp).
void Runner::run_sections(Link const& link, Memory& memory, std::span<double> signal) {
  for (double& x : signal) {
    double d = x - memory.last;
    memory.last = x;
    for (std::size_t i = 0; i < memory.states.size(); ++i) {
      auto const& s = link.sections[i];
      auto& [e, r] = memory.states[i];
      double const change = s.p * d + r;
      e += change;
      r = change + s.q * d - s.k * e - s.b * change;
      if (link.blocks_constant) {
        d = change;
        memory.passed = e;
      } else {
        d += change;
        memory.sum += change;
      }
    }
    double const filtered = link.blocks_constant ? memory.passed : x + memory.sum;
    x += link.share * (filtered - x);
  }
}

/// y[n] = origin + sum of taps[k] (x[n - k] - origin)
void Runner::run_taps(Link const& link, Memory& memory, std::span<double> signal) {
  std::size_t const before = link.taps.size() - 1;
  padded_ = memory.before;
  for (double const x : signal) padded_.push_back(x - memory.origin);
  memory.before.assign(padded_.end() - static_cast<std::ptrdiff_t>(before), padded_.end());
  constexpr std::size_t group = 512;  // sums that stay in the cache while all taps pass over them
  for (std::size_t first = 0; first < signal.size(); first += group) {
    auto const sums = signal.subspan(first, std::min(group, signal.size() - first));
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t k = 0; k <= before; ++k) {
      double const tap = link.taps[k];
      double const* const x = padded_.data() + first + before - k;
      for (std::size_t n = 0; n < sums.size(); ++n) sums[n] += tap * x[n];
    }
    for (double& y : sums) y += memory.origin;
  }
}

void Runner::run(std::span<double> signal) {
  if (signal.empty()) return;
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    auto const& link = chain_[i];
    auto& memory = memories_[i];
    if (!is_running_) {
      memory.origin = memory.last = signal.front();
      memory.states.resize(link.sections.size());
      if (!link.taps.empty()) memory.before.assign(link.taps.size() - 1, 0.0);
    }
    if (link.taps.empty()) {
      run_sections(link, memory, signal);
    } else {
      run_taps(link, memory, signal);
    }
  }
  is_running_ = true;
}

std::vector<double> respond(Chain const& chain, std::span<double const> input) {
  std::vector<double> signal(input.begin(), input.end());
  Runner(chain).run(signal);
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
