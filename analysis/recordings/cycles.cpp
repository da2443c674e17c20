#include "analysis/recordings/cycles.hpp"

#include "analysis/recordings/time_steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axisc::recordings {

namespace {

/// Beyond it whole numbers are no longer exact, and squares of differences overflow sooner or later.
constexpr double largest_position = 1e15;
/// A longer pause is not a lost sample.
constexpr double longest_gap = 1000;
/// Of a step, by which a sample may come early or late: times are rounded when they are written.
constexpr double step_tolerance = 0.25;
/// Of the sample time, by which the median may differ from the header, and multiples from whole numbers.
constexpr double header_tolerance = 0.01;
/// Times without a header are rounded.
constexpr double median_tolerance = 0.05;
/// More than a quarter of a short recording may be missing.
constexpr std::size_t always_bearable = 2000;

/// Which sample of a clock is of which cycle.
struct Grid {
  double ms_per_unit = 1;  ///< of the times
  double step_ms = 1;
  std::int64_t every = 1;  ///< samples a cycle
  std::int64_t first = 0;  ///< step of the first sample; cycle 0 is step 0
};

/// `receive(sample, cycle, time)`, the time in ms, for each sample that is of a cycle. The sample whose
/// distance from the one before is not a whole number of steps, with that distance.
struct BadDistance {
  std::size_t sample = 0;
  double ms = 0;
};
template <class Receive>
std::optional<BadDistance> for_each_cycle(Clock const& clock, Grid const& grid, Receive receive) {
  if (clock.is_counted) {
    for (std::size_t i = 0; i < clock.samples; ++i) receive(i, static_cast<std::int64_t>(i), 0.0);
    return std::nullopt;
  }
  std::optional<BadDistance> bad;
  std::int64_t step = grid.first;
  double last = 0;
  for_each_part(clock.times, [&](std::size_t first, std::span<double const> times) {
    for (std::size_t i = 0; i < times.size() && !bad; ++i) {
      double const time = times[i] * grid.ms_per_unit;
      if (first + i > 0) {
        double const passed = (time - last) / grid.step_ms;
        double const whole = std::round(passed);
        bool const is_whole = std::abs(passed - whole) <= step_tolerance && whole <= longest_gap;
        if (!is_whole) {
          bad = BadDistance{.sample = first + i, .ms = time - last};
          return;
        }
        last = time;
        if (whole == 0) continue;
        step += static_cast<std::int64_t>(whole);
      }
      last = time;
      if (step % grid.every == 0) receive(first + i, step / grid.every, time);
    }
  });
  return bad;
}

double ms_per_unit(Clock const& clock) {
  return clock.unit == TimeUnit::seconds ? 1000 : 1;
}

double begin_ms(Clock const& clock) {
  return clock.is_counted ? 0 : clock.times.front() * ms_per_unit(clock);
}

std::variant<Grid, BadCycles> grid_of(Clock const& clock, std::size_t channel, double zero_ms,
                                      double cycle_ms) {
  Grid grid{.ms_per_unit = ms_per_unit(clock), .step_ms = cycle_ms};
  if (clock.is_counted || clock.samples < 2) return grid;
  double const median = sample_time(clock);
  auto const bad = [&](CycleProblem problem) {
    return BadCycles{.problem = problem, .channel = channel, .step = median};
  };
  if (clock.sample_time && std::abs(median - *clock.sample_time) > header_tolerance * median) {
    return bad(CycleProblem::header_disagrees);
  }
  double const cycles = median / cycle_ms;
  if (std::abs(cycles - 1) > median_tolerance) {
    double const times = std::max(cycles, 1 / cycles);
    double const whole = std::round(times);
    if (whole < 2 || std::abs(times - whole) > header_tolerance * whole) return bad(CycleProblem::other_step);
    if (cycles > 1) return bad(CycleProblem::decimated);
    grid.every = static_cast<std::int64_t>(whole);
    grid.step_ms = cycle_ms / whole;
  }
  double const first = std::round((begin_ms(clock) - zero_ms) / grid.step_ms);
  constexpr double farthest = 1e15;
  if (!(std::abs(first) <= farthest)) return bad(CycleProblem::no_samples);
  grid.first = static_cast<std::int64_t>(first);
  return grid;
}

struct Span {
  std::int64_t first = 0, last = 0;
};

class Joiner {
 public:
  Joiner(Recording const& recording, std::span<std::size_t const> chosen, double cycle_ms)
      : recording_(recording), chosen_(chosen), cycle_ms_(cycle_ms) {}

  std::variant<CycleSignals, BadCycles> join() {
    if (auto bad = check_channels()) return *bad;
    for (auto const channel : chosen_) zero_ms_ = std::max(zero_ms_, begin_ms(clock_of(channel)));
    for (auto const channel : chosen_) {
      auto grid = grid_of(clock_of(channel), channel, zero_ms_, cycle_ms_);
      if (auto* const bad = std::get_if<BadCycles>(&grid)) return *bad;
      grids_.push_back(std::get<Grid>(grid));
      if (auto bad = limit(channel)) return *bad;
    }
    if (span_.first > span_.last) return bad(CycleProblem::no_samples, chosen_.front());
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      if (!add(i)) return bad(CycleProblem::many_lost, chosen_[i]);
    }
    auto& gaps = result_.gaps;
    std::sort(gaps.begin(), gaps.end());
    gaps.erase(std::unique(gaps.begin(), gaps.end()), gaps.end());
    result_.repeated = clock_of(chosen_.front()).repeated;
    return std::move(result_);
  }

 private:
  [[nodiscard]] Channel const& channel(std::size_t index) const { return recording_.channels[index]; }
  [[nodiscard]] Clock const& clock_of(std::size_t index) const {
    return recording_.clocks[channel(index).clock];
  }
  [[nodiscard]] static BadCycles bad(CycleProblem problem, std::size_t channel,
                                     std::optional<std::size_t> sample = std::nullopt) {
    return {.problem = problem, .channel = channel, .sample = sample};
  }

  [[nodiscard]] std::optional<BadCycles> check_channels() const {
    for (auto const each : chosen_) {
      auto const& clock = clock_of(each);
      if (clock.problem) return bad(CycleProblem::bad_clock, each);
      if (channel(each).bad) return bad(CycleProblem::bad_value, each);
      if (clock.samples == 0) return bad(CycleProblem::no_samples, each);
      if (clock.is_counted != clock_of(chosen_.front()).is_counted) {
        return bad(CycleProblem::uncommon_clocks, each);
      }
    }
    return std::nullopt;
  }

  /// Narrows the common span to that of a channel, and looks at its values.
  std::optional<BadCycles> limit(std::size_t index) {
    auto const& values = channel(index).values;
    std::optional<Span> own;
    std::optional<BadCycles> refused;
    Cursor cursor(values);
    auto const distance = for_each_cycle(clock_of(index), grids_.back(),
                                         [&](std::size_t sample, std::int64_t cycle, double time) {
                                           double const value = cursor.at(sample);
                                           if (std::isnan(value)) return;
                                           if (std::abs(value) > largest_position && !refused) {
                                             refused = bad(CycleProblem::too_large, index, sample);
                                             refused->value = value;
                                           }
                                           if (!own) own = Span{.first = cycle, .last = cycle};
                                           own->last = cycle;
                                           last_time_ = time;
                                         });
    if (distance) {
      auto bad_distance = bad(CycleProblem::other_distance, index, distance->sample);
      bad_distance.step = distance->ms;
      return bad_distance;
    }
    if (refused) return refused;
    if (!own) return bad(CycleProblem::no_samples, index);
    bool const is_first = grids_.size() == 1;
    span_.first = is_first ? own->first : std::max(span_.first, own->first);
    span_.last = is_first ? own->last : std::min(span_.last, own->last);
    // How long its cycles are: the same for all clocks of a recording.
    double const cycle = (last_time_ - zero_ms_) / std::max(static_cast<double>(own->last), 1.0);
    if (own->last < 2 || clock_of(index).is_counted) return std::nullopt;
    if (cycle_of_clocks_ &&
        std::abs(cycle - *cycle_of_clocks_) * static_cast<double>(own->last) > cycle_ms_) {
      return bad(CycleProblem::drift, index);
    }
    if (!cycle_of_clocks_) cycle_of_clocks_ = cycle;
    return std::nullopt;
  }

  /// The values of the span; those that are missing lie between their neighbours. False where too many are.
  [[nodiscard]] bool add(std::size_t i) {
    auto& signal = result_.signals.emplace_back();
    Cursor cursor(channel(chosen_[i]).values);
    std::int64_t last_cycle = 0;
    double last_value = 0;
    bool has_last = false;
    bool is_bearable = true;
    std::size_t lost = 0;
    static_cast<void>(
        for_each_cycle(clock_of(chosen_[i]), grids_[i], [&](std::size_t sample, std::int64_t cycle, double) {
          double const value = cursor.at(sample);
          bool const is_done = signal.size() > 0 && last_cycle >= span_.last;
          if (std::isnan(value) || is_done || !is_bearable) return;
          auto const missing = has_last ? cycle - last_cycle - 1 : 0;
          for (std::int64_t k = 1; k <= missing; ++k) {
            auto const at = last_cycle + k;
            if (at < span_.first || at > span_.last) continue;
            ++lost;
            result_.gaps.push_back(static_cast<std::size_t>(at - span_.first));
            signal.push(last_value +
                        (value - last_value) * static_cast<double>(k) / static_cast<double>(missing + 1));
          }
          if (cycle >= span_.first && cycle <= span_.last) signal.push(value);
          last_cycle = cycle;
          last_value = value;
          has_last = true;
          is_bearable = lost <= always_bearable + signal.size() / 4;
        }));
    return is_bearable;
  }

  /// Values one after the other, a part at a time.
  class Cursor {
   public:
    explicit Cursor(Signal const& signal) : signal_(signal) {}
    double at(std::size_t index) {
      if (index < first_ || index >= first_ + part_.size()) {
        constexpr std::size_t size = 4096;
        first_ = index;
        part_.resize(std::min(size, signal_.size() - index));
        signal_.read(first_, part_);
      }
      return part_[index - first_];
    }

   private:
    Signal const& signal_;
    std::vector<double> part_;
    std::size_t first_ = 0;
  };

  Recording const& recording_;
  std::span<std::size_t const> chosen_;
  double cycle_ms_;
  double zero_ms_ = -1e300;  ///< the latest begin
  double last_time_ = 0;
  std::optional<double> cycle_of_clocks_;
  std::vector<Grid> grids_;  ///< by chosen channel
  Span span_;
  CycleSignals result_;
};

}  // namespace

double sample_time(Clock const& clock) {
  if (clock.is_counted || clock.samples < 2) return clock.sample_time.value_or(0);
  return usual_step(clock.times) * ms_per_unit(clock);
}

std::variant<CycleSignals, BadCycles> by_cycles(Recording const& recording,
                                                std::span<std::size_t const> chosen, double cycle_ms) {
  return Joiner(recording, chosen, cycle_ms).join();
}

}  // namespace axisc::recordings
