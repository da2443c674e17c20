#include "analysis/comparison/residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace axisc::comparison {

namespace {

/// A fraction of a cycle is believed if it reduces the error to this share at most.
constexpr double fraction_gain = 0.7;
/// Cycles after a gap that do not count: as many as the chain takes to settle, but at most these.
constexpr std::size_t longest_shadow = 400;
/// Cycles of a recording that are in memory at once.
constexpr std::size_t window_size = 16384;

bool is_multiple(double value, double step) {
  constexpr double tolerance = 1e-3;
  double const steps = value / step;
  return std::abs(steps - std::round(steps)) < tolerance;
}

/// A part of two signals: of the cycles from `first` on, those from `from` to `to` are looked at.
struct Window {
  std::size_t first = 0;
  std::span<double const> computed, output;
  std::size_t from = 0, to = 0;
  std::vector<bool> const& counted;

  [[nodiscard]] double recorded(std::size_t n) const { return output[n - first]; }
  /// `computed` at n - lag, within the window.
  [[nodiscard]] bool has(std::size_t n, int lag) const {
    auto const at = index(n, lag);
    return at >= 0 && at < static_cast<std::ptrdiff_t>(computed.size());
  }
  [[nodiscard]] double answer(std::size_t n, int lag) const {
    return computed[static_cast<std::size_t>(index(n, lag))];
  }

 private:
  [[nodiscard]] std::ptrdiff_t index(std::size_t n, int lag) const {
    return static_cast<std::ptrdiff_t>(n - first) - lag;
  }
};

struct Sums {
  double squares = 0, largest = 0;
  std::size_t count = 0;
  void add(double error) {
    squares += error * error;
    largest = std::max(largest, std::abs(error));
    ++count;
  }
  void add(Sums const& other) {
    squares += other.squares;
    largest = std::max(largest, other.largest);
    count += other.count;
  }
  [[nodiscard]] Residual residual(double delay) const {
    return {delay, largest, count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count))};
  }
};

/// At every whole lag.
class WholeLags {
 public:
  void add(Window const& window) {
    std::vector<std::uint32_t> places;  // of the cycles that count, in the window
    for (std::size_t n = window.from; n < window.to; ++n) {
      if (window.counted[n]) places.push_back(static_cast<std::uint32_t>(n - window.first));
    }
    auto const size = static_cast<std::int64_t>(window.computed.size());
    for (std::size_t i = 0; i < lags; ++i) {
      std::int64_t const lag = static_cast<std::int64_t>(i) - longest_lag;
      Sums sums;
      for (std::int64_t const place : places) {
        if (place < lag || place - lag >= size) continue;
        sums.add(window.output[static_cast<std::size_t>(place)] -
                 window.computed[static_cast<std::size_t>(place - lag)]);
      }
      sums_.at(i).add(sums);
    }
  }
  [[nodiscard]] Residual best() const {
    Residual best = at(0);
    for (int distance = 1; distance <= longest_lag; ++distance) {
      for (int const lag : {distance, -distance}) {
        auto const other = at(lag);
        if (other.rms < best.rms) best = other;
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Residual at(int lag) const {
    auto const index = std::ptrdiff_t{lag} + longest_lag;
    return sums_.at(static_cast<std::size_t>(index)).residual(lag);
  }
  std::array<Sums, lags> sums_{};
};

/// The fraction of the cycle from `lag` to the next one with the smallest sum of squares.
struct PartOfCycle {
  int lag = 0;
  double projection = 0, energy = 0;
  Sums sums{};

  [[nodiscard]] double part() const { return energy > 0 ? std::clamp(projection / energy, 0.0, 1.0) : 0; }
  void project(Window const& window) {
    each(window, [&](double error, double step) {
      projection += step * error;
      energy += step * step;
    });
  }
  void add(Window const& window) {
    double const share = part();
    each(window, [&](double error, double step) { sums.add(error - share * step); });
  }

 private:
  template <class Use>
  void each(Window const& window, Use use) const {
    for (std::size_t n = window.from; n < window.to; ++n) {
      if (!window.counted[n] || !window.has(n, lag) || !window.has(n, lag + 1)) continue;
      double const early = window.answer(n, lag);
      use(window.recorded(n) - early, window.answer(n, lag + 1) - early);
    }
  }
};

/// Calls `use` for windows that together cover the recording, each with the cycles around it that lags need.
template <class Use>
void for_each_window(Chain const& chain, Recording const& recording, std::vector<bool> const& counted,
                     Use use) {
  std::size_t const size = recording.output.size();
  Runner runner(chain, recording.first);
  std::vector<double> computed, output;
  std::size_t first = 0;
  std::size_t done = 0;
  while (done < size) {
    std::size_t const known = first + computed.size();
    std::size_t const more = std::min(window_size, size - known);
    std::size_t const kept = computed.size();
    computed.resize(kept + more);
    output.resize(kept + more);
    std::span<double> const fresh(computed.data() + kept, more);
    recording.input.read(known, fresh);
    runner.run(fresh);
    recording.output.read(known, {output.data() + kept, more});
    std::size_t const to = known + more == size ? size : known + more - longest_lag;
    use(Window{
        .first = first, .computed = computed, .output = output, .from = done, .to = to, .counted = counted});
    done = to;
    std::size_t const past = done > first + longest_lag ? done - first - longest_lag : 0;
    computed.erase(computed.begin(), computed.begin() + static_cast<std::ptrdiff_t>(past));
    output.erase(output.begin(), output.begin() + static_cast<std::ptrdiff_t>(past));
    first += past;
  }
}

}  // namespace

double resolution(Signal const& signal, std::span<std::size_t const> gaps) {
  constexpr std::array<double, 7> steps{1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6};
  std::size_t coarsest = 0;
  auto gap = gaps.begin();
  for_each_part(signal, [&](std::size_t first, std::span<double const> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (gap != gaps.end() && *gap == first + i) {
        ++gap;
        continue;
      }
      while (coarsest < steps.size() && !is_multiple(values[i], steps.at(coarsest))) ++coarsest;
    }
  });
  return coarsest < steps.size() ? steps.at(coarsest) : 0;
}

std::vector<bool> counted_cycles(Recording const& recording, Counting const& counting) {
  double const step = counting.output_resolution;
  std::vector<bool> counted(recording.output.size(), false);
  if (counted.empty()) return counted;
  double const start = recording.input.front();
  std::size_t resting = 0;
  bool rests = true;
  double last = recording.output.front();
  std::vector<double> outputs;
  for_each_part(recording.input, [&](std::size_t first, std::span<double const> inputs) {
    outputs.resize(inputs.size());
    recording.output.read(first, outputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      rests = rests && inputs[i] == start && std::abs(outputs[i] - start) <= step;
      if (rests) ++resting;
      counted[first + i] = std::abs(outputs[i] - last) > step;
      last = outputs[i];
    }
  });
  // Without rest at the start, the state is unknown.
  std::size_t const begin = std::min(counted.size(), resting < 3 ? counting.settling : resting);
  std::fill(counted.begin(), counted.begin() + static_cast<std::ptrdiff_t>(begin), false);
  std::size_t const shadow = std::min(counting.settling, longest_shadow);
  std::size_t cleared = 0;
  for (auto const gap : recording.gaps) {
    std::size_t const end = std::min(counted.size(), gap + shadow + 1);
    for (std::size_t n = std::max(gap, cleared); n < end; ++n) counted[n] = false;
    cleared = std::max(cleared, end);
  }
  return counted;
}

Residual residual_of(std::span<double const> computed, std::span<double const> output,
                     std::vector<bool> const& counted) {
  WholeLags whole;
  whole.add({.first = 0,
             .computed = computed,
             .output = output,
             .from = 0,
             .to = output.size(),
             .counted = counted});
  return whole.best();
}

Residual residual_of(Chain const& chain, Recording const& recording, std::vector<bool> const& counted) {
  WholeLags whole;
  for_each_window(chain, recording, counted, [&](Window const& window) { whole.add(window); });
  Residual best = whole.best();
  auto const lag = static_cast<int>(best.delay_cycles);
  std::array<PartOfCycle, 2> parts{{{.lag = lag}, {.lag = lag - 1}}};
  for_each_window(chain, recording, counted, [&](Window const& window) {
    for (auto& part : parts) part.project(window);
  });
  for_each_window(chain, recording, counted, [&](Window const& window) {
    for (auto& part : parts) part.add(window);
  });
  for (auto const& part : parts) {
    auto const other = part.sums.residual(part.lag + part.part());
    if (other.rms < fraction_gain * best.rms) best = other;
  }
  return best;
}

}  // namespace axisc::comparison
