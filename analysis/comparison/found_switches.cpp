#include "analysis/comparison/found_switches.hpp"

#include "analysis/comparison/fade_weight.hpp"
#include "analysis/comparison/residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace axisc::comparison {

namespace {

constexpr std::size_t block = 128;
/// A switch has to save this many times the squares that rounding explains, so that noise switches nothing.
constexpr double fewest_squares = 100;
constexpr std::size_t most_switches = 100;

/// Answers with the filter off and on, a piece of the recording at a time; the last `longest_lag` cycles are
/// kept.
class BothAnswers {
 public:
  BothAnswers(Configured const& configured, std::size_t first)
      : off_(readings(steady(configured, false)).front().chain, first),
        on_(readings(steady(configured, true)).front().chain, first) {}

  void run(std::span<double const> input) {
    for (auto* answer : {&off, &on}) {
      auto const kept = std::min(answer->size(), static_cast<std::size_t>(2 * longest_lag));
      answer->erase(answer->begin(), answer->end() - static_cast<std::ptrdiff_t>(kept));
      answer->insert(answer->end(), input.begin(), input.end());
    }
    off_.run(std::span(off).last(input.size()));
    on_.run(std::span(on).last(input.size()));
  }

  std::vector<double> off, on;

 private:
  Runner off_, on_;
};

/// Sums of squares in a block, filter off and on, at one offset of the columns.
using Squares = std::array<double, 2>;

/// Calls `use(n, output, off, on)` for the cycles that count: the recorded output, and functions that give
/// the answers `lag` cycles before cycle n. Cycles at the ends that have no answer for every lag are left
/// out.
template <class Use>
void for_each_counted(Recording const& recording, Configured const& configured,
                      std::vector<bool> const& counted, Use use) {
  BothAnswers answers(configured, recording.first);
  std::vector<double> outputs;
  for_each_part(recording.input, [&](std::size_t first, std::span<double const> input) {
    answers.run(input);
    std::size_t const known = first + input.size();        // cycles with an answer
    std::size_t const begin = known - answers.off.size();  // of the known answers
    std::size_t const from = begin == 0 ? longest_lag : begin + longest_lag;
    std::size_t const to = known - std::min<std::size_t>(known, longest_lag);
    if (to <= from) return;
    outputs.resize(to - from);
    recording.output.read(from, outputs);
    for (std::size_t n = from; n < to; ++n) {
      if (!counted[n]) continue;
      auto const at = static_cast<std::ptrdiff_t>(n - begin);
      use(n, outputs[n - from], answers.off.begin() + at, answers.on.begin() + at);
    }
  });
}

/// The offset at which one of the two explains most blocks best, and their squares there.
struct Blocks {
  int lag = 0;
  std::vector<Squares> squares;
};

Blocks blocks_of(Recording const& recording, Configured const& configured, std::vector<bool> const& counted,
                 double expected) {
  std::vector<std::array<Squares, lags>> all(recording.output.size() / block + 1);
  for_each_counted(recording, configured, counted, [&](std::size_t n, double output, auto off, auto on) {
    for (std::size_t i = 0; i < lags; ++i) {
      auto const lag = static_cast<std::ptrdiff_t>(i) - longest_lag;
      double const without = output - *(off - lag);
      double const with = output - *(on - lag);
      all[n / block].at(i)[0] += without * without;
      all[n / block].at(i)[1] += with * with;
    }
  });
  // Logarithms: a block in which the filter changes over is explained by neither, and must not outweigh the
  // others.
  std::array<double, lags> sums{};
  for (auto const& one : all) {
    for (std::size_t i = 0; i < lags; ++i) {
      sums.at(i) += std::log(expected + std::min(one.at(i)[0], one.at(i)[1]));
    }
  }
  auto const best = static_cast<std::size_t>(std::min_element(sums.begin(), sums.end()) - sums.begin());
  Blocks found{.lag = static_cast<int>(best) - longest_lag, .squares = {}};
  found.squares.reserve(all.size());
  for (auto const& one : all) found.squares.push_back(one.at(best));
  return found;
}

/// In each block, on or off: the sequence with the least sum of squares, each switch costing `price`.
std::vector<bool> cheapest_states(std::vector<Squares> const& squares, bool on_at_start, double price) {
  std::array<double, 2> cost{on_at_start ? price : 0, on_at_start ? 0 : price};
  std::array<std::vector<bool>, 2> switched;
  for (auto const& block_squares : squares) {
    auto const before = cost;
    for (std::size_t state = 0; state < 2; ++state) {
      bool const from_other = before.at(1 - state) + price < before.at(state);
      switched.at(state).push_back(from_other);
      cost.at(state) =
          (from_other ? before.at(1 - state) + price : before.at(state)) + block_squares.at(state);
    }
  }
  std::vector<bool> on(squares.size());
  std::size_t state = cost[1] < cost[0] ? 1 : 0;
  for (std::size_t i = squares.size(); i-- > 0;) {
    on[i] = state == 1;
    if (switched.at(state)[i]) state = 1 - state;
  }
  return on;
}

/// One switch, and the cycles in which to look for it.
struct Sought {
  bool on = false;
  std::size_t length = 0;           ///< of the change-over
  std::size_t first = 0, last = 0;  ///< where it may begin
  std::size_t begin = 0;            ///< of the cycles that are kept
  std::vector<double> errors{},
      steps{};  ///< of the state before; from it to the state after; 0 where a cycle does not count

  /// The beginning with the least sum of squares.
  [[nodiscard]] std::size_t best() const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t found = first;
    for (std::size_t start = first; start <= last; ++start) {
      double sum = 0;
      for (std::size_t i = 0; i < errors.size() && sum < least; ++i) {
        std::size_t const n = begin + i;
        double const w = n < start ? 0 : n + 1 - start < length ? fade_weight(n + 1 - start, length) : 1;
        double const error = errors[i] - w * steps[i];
        sum += error * error;
      }
      if (sum < least) {
        least = sum;
        found = start;
      }
    }
    return found;
  }
};

/// A block that is explained differently from the one before lies in the middle of the change-over.
std::vector<Sought> sought_switches(std::vector<bool> const& on, bool on_at_start, ChangeOver const& lengths,
                                    std::size_t cycles) {
  std::vector<Sought> all;
  bool state = on_at_start;
  for (std::size_t i = 0; i < on.size(); ++i) {
    if (on[i] == state) continue;
    state = on[i];
    Sought one{.on = state, .length = state ? lengths.on : lengths.off};
    std::size_t const early = one.length + 2 * block;
    one.first = i * block > early ? i * block - early : 0;
    one.last = std::min((i + 2) * block, cycles - 1);
    one.begin = one.first > block ? one.first - block : 0;
    std::size_t const end = std::min(one.last + one.length + block, cycles);
    one.errors.assign(end - one.begin, 0.0);
    one.steps.assign(end - one.begin, 0.0);
    all.push_back(std::move(one));
  }
  return all;
}

void keep_answers(std::vector<Sought>& all, int lag, Recording const& recording, Configured const& configured,
                  std::vector<bool> const& counted) {
  for_each_counted(recording, configured, counted, [&](std::size_t n, double output, auto off, auto on) {
    // In cycles of the setpoint: what the output shows at n was computed `lag` cycles before.
    auto const cycle = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(n) - lag);
    for (auto& one : all) {
      if (cycle < one.begin || cycle - one.begin >= one.errors.size()) continue;
      double const before = one.on ? *(off - lag) : *(on - lag);
      double const after = one.on ? *(on - lag) : *(off - lag);
      one.errors[cycle - one.begin] = output - before;
      one.steps[cycle - one.begin] = after - before;
    }
  });
}

}  // namespace

std::vector<KernelSwitch> found_switches(Recording const& recording, Configured const& configured,
                                         ChangeOver const& lengths) {
  if (!configured.kernel || recording.output.size() < 4 * block) return {};
  double const step = resolution(recording.output, recording.gaps);
  auto const settling = settling_cycles(readings(steady(configured, true)).front().chain);
  auto const counted = counted_cycles(recording, {.settling = settling, .output_resolution = step});
  double const rounding = std::hypot(step, resolution(recording.input, recording.gaps)) / std::sqrt(12.0);
  double const expected = static_cast<double>(block) * std::max(rounding * rounding, 1e-18);
  auto const blocks = blocks_of(recording, configured, counted, expected);
  auto const states = cheapest_states(blocks.squares, configured.kernel_on, fewest_squares * expected);
  auto sought = sought_switches(states, configured.kernel_on, lengths, recording.output.size());
  if (sought.size() > most_switches) return {};
  keep_answers(sought, blocks.lag, recording, configured, counted);
  std::vector<KernelSwitch> found;
  for (auto const& one : sought) {
    auto const cycle = one.best();
    if (!found.empty() && cycle < found.back().cycle + found.back().fade_cycles) return {};
    found.push_back(
        {.cycle = cycle, .kernel = one.on ? configured.kernel : std::nullopt, .fade_cycles = one.length});
  }
  return found;
}

}  // namespace axisc::comparison
