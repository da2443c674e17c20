// Channels brought together by time: a value a cycle of the control.
#pragma once

#include "analysis/recordings/recording.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace axisc::recordings {

struct CycleSignals {
  std::vector<Signal> signals;    ///< by chosen channel, all of one size
  std::vector<std::size_t> gaps;  ///< cycles that a channel lacks and that are interpolated, rising
  std::size_t repeated = 0;       ///< samples of the first channel that were repeated
};

enum class CycleProblem : std::uint8_t {
  bad_clock,         ///< Clock::problem
  bad_value,         ///< Channel::bad
  too_large,         ///< a value that cannot be a position: `value`
  no_samples,        ///< of the channel, or none at the time of the others
  header_disagrees,  ///< the sample time of the header is not `step`
  other_step,        ///< `step` is neither the cycle nor a whole part of it
  decimated,         ///< `step` is so many cycles
  other_distance,    ///< a sample at `sample` comes `step` after the one before: not a whole number of cycles
  many_lost,         ///< more than a quarter of the cycles
  drift,             ///< clocks that run at different speeds
  uncommon_clocks,   ///< one has times, another one counts rows
};

struct BadCycles {
  CycleProblem problem = CycleProblem::no_samples;
  std::size_t channel = 0;                 ///< index into Recording::channels
  std::optional<std::size_t> sample = {};  ///< of its clock
  double step = 0;                         ///< ms
  double value = 0;
};

/// Of the samples of a clock, ms: usual_step(), or what the header says where there are no times.
[[nodiscard]] double sample_time(Clock const& clock);

/// `chosen` channels (at least one) by cycles of `cycle_ms`, from the latest begin to the earliest end. Of a
/// channel that was sampled k times a cycle, every k-th sample is taken; a clock without times has a sample a
/// cycle.
[[nodiscard]] std::variant<CycleSignals, BadCycles> by_cycles(Recording const& recording,
                                                              std::span<std::size_t const> chosen,
                                                              double cycle_ms);

}  // namespace axisc::recordings
