// Does a recording agree with the chain that the lists describe, and if not, which reading does it agree
// with?
#pragma once

#include "analysis/comparison/readings.hpp"
#include "analysis/recordings/signal.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::comparison {

using recordings::Signal;

/// The two columns of a recording, a value a cycle, in the same unit.
struct Recording {
  Signal input, output;
  std::vector<std::size_t> gaps;  ///< cycles whose values were not recorded and are interpolated
  std::size_t first = 0;          ///< cycle of the first value, where this is a part of a recording
};

/// How far a chain's answer is from the recorded output where the output moves.
struct Residual {
  double delay_cycles = 0;  ///< by which the recorded output lags the chain's
  double largest = 0;
  double rms = 0;
};

enum class Verdict : std::uint8_t {
  same,
  delayed,      ///< the same but for a delay of the output column
  different,    ///< not what axisc computes
  cannot_tell,  ///< too little motion
};

struct Explained {
  Reading reading;
  Residual residual;
};

struct Comparison {
  Verdict verdict = Verdict::cannot_tell;
  Residual listed{};
  double input_resolution = 0;  ///< 0 where the numbers have more than six decimals
  double output_resolution = 0;
  double allowed_rms = 0;      ///< rms error of the listed chain that rounding to these resolutions explains
  double allowed_largest = 0;  ///< likewise the largest error
  std::size_t compared = 0;    ///< cycles that count
  std::size_t lost = 0;
  /// Every reading that the recording does not rule out, best first: rounding of both columns explains its
  /// largest and rms deviation, and its rms is close to that of the best. If the listed chain fits, too: the
  /// readings that this motion cannot tell apart from it.
  std::vector<Explained> fitting{};
  std::optional<Explained> next{};  ///< the best of those that are ruled out
};

/// Whole cycles by which the recorded output may lag the chain's, or lead it.
inline constexpr int longest_lag = 10;
inline constexpr std::size_t lags = 2 * longest_lag + 1;

/// Only a single explanation may be believed: see `fitting`. Lags of up to `longest_lag`, and fractions of a
/// cycle for the listed chain, are found. `all`: of readings(), the listed one first.
[[nodiscard]] Comparison compare(Recording const& recording, std::vector<Reading> const& all);

}  // namespace axisc::comparison
