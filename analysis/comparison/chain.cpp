#include "analysis/comparison/chain.hpp"

#include "analysis/comparison/fade_weight.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace axisc::comparison {

namespace {

constexpr std::size_t longest_settling = 20000;
constexpr double settled = 1e-6;

std::vector<double> impulse_answer(Chain const& chain) {
  std::vector<double> impulse(settling_cycles(chain) + 2, 0.0);
  impulse[1] = 1;
  return respond(chain, impulse);
}

}  // namespace

std::size_t most_taps(Link const& link) {
  std::size_t most = link.taps.size();
  for (auto const& one : link.switches) most = std::max(most, one.taps.size());
  return most;
}

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

Runner::Runner(Chain chain, std::size_t first)
    : chain_(std::move(chain)), memories_(chain_.size()), cycle_(first) {}

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

/// y[n] = origin + sum of taps[k] (x[n - k] - origin), x[n] being padded[n + longest - 1]; from cycle `from`
/// of the piece on.
void Runner::apply(std::vector<double> const& taps, double origin, std::size_t from,
                   std::span<double> signal) const {
  constexpr std::size_t group = 512;  // sums that stay in the cache while all taps pass over them
  for (std::size_t first = 0; first < signal.size(); first += group) {
    auto const sums = signal.subspan(first, std::min(group, signal.size() - first));
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t k = 0; k < taps.size(); ++k) {
      double const tap = taps[k];
      double const* const x = padded_.data() + from + first - k;
      for (std::size_t n = 0; n < sums.size(); ++n) sums[n] += tap * x[n];
    }
    for (double& y : sums) y += origin;
  }
}

void Runner::run_taps(Link const& link, Memory& memory, std::span<double> signal) {
  std::size_t const before = most_taps(link) - 1;
  padded_ = memory.before;
  for (double const x : signal) padded_.push_back(x - memory.origin);
  memory.before.assign(padded_.end() - static_cast<std::ptrdiff_t>(before), padded_.end());
  auto const* taps = &link.taps;
  std::size_t from = 0;  // of the piece
  for (auto const& next : link.switches) {
    std::size_t const at = next.cycle > cycle_ ? std::min(next.cycle - cycle_, signal.size()) : 0;
    if (at > from) apply(*taps, memory.origin, before + from, signal.subspan(from, at - from));
    from = std::max(from, at);
    std::size_t const fade_end = next.cycle + next.fade_cycles;
    std::size_t const end = fade_end > cycle_ ? std::min(fade_end - cycle_, signal.size()) : 0;
    if (end > from && from >= at && next.cycle < cycle_ + signal.size()) {
      auto const faded = signal.subspan(from, end - from);
      before_fade_.resize(faded.size());
      apply(*taps, memory.origin, before + from, before_fade_);
      apply(next.taps, memory.origin, before + from, faded);
      for (std::size_t n = 0; n < faded.size(); ++n) {
        double const w = fade_weight(cycle_ + from + n + 1 - next.cycle, next.fade_cycles);
        faded[n] = before_fade_[n] + w * (faded[n] - before_fade_[n]);
      }
      from = end;
    }
    if (next.cycle < cycle_ + signal.size()) taps = &next.taps;
  }
  if (from < signal.size()) apply(*taps, memory.origin, before + from, signal.subspan(from));
}

void Runner::run(std::span<double> signal) {
  if (signal.empty()) return;
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    auto const& link = chain_[i];
    auto& memory = memories_[i];
    if (!is_running_) {
      memory.origin = memory.last = signal.front();
      memory.states.resize(link.sections.size());
      if (!link.taps.empty()) memory.before.assign(most_taps(link) - 1, 0.0);
    }
    if (link.taps.empty()) {
      run_sections(link, memory, signal);
    } else {
      run_taps(link, memory, signal);
    }
  }
  is_running_ = true;
  cycle_ += signal.size();
}

std::vector<double> respond(Chain const& chain, std::span<double const> input, std::size_t first) {
  std::vector<double> signal(input.begin(), input.end());
  Runner(chain, first).run(signal);
  return signal;
}

std::size_t settling_cycles(Chain const& chain) {
  std::size_t cycles = 1;
  for (auto const& link : chain) {
    cycles += most_taps(link);
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

double noise_gain(Chain const& chain) {
  auto const answer = impulse_answer(chain);
  return std::sqrt(std::inner_product(answer.begin(), answer.end(), answer.begin(), 0.0));
}

double worst_gain(Chain const& chain) {
  double largest = 0;
  auto const take = [&largest](Chain const& steady) {
    auto const answer = impulse_answer(steady);
    largest = std::max(largest, std::transform_reduce(answer.begin(), answer.end(), 0.0, std::plus<>(),
                                                      [](double value) { return std::abs(value); }));
  };
  // Links are switched one at a time: an axis has one kernel.
  Chain steady = chain;
  for (auto& link : steady) link.switches.clear();
  take(steady);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    for (auto const& one : chain[i].switches) {
      steady[i].taps = one.taps;
      take(steady);
    }
    steady[i].taps = chain[i].taps;
  }
  return largest;
}

}  // namespace axisc::comparison
