// Does a recording agree with the chain that the lists describe, and if not, which reading does it agree with?
#pragma once

#include "comparison/readings.hpp"
#include "comparison/signal.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace axisc::comparison {

/// The two columns of a recording, a value a cycle, in the same unit.
struct Recording {
  Signal input, output;
  std::vector<std::size_t> gaps;  ///< cycles whose values were not recorded and are interpolated
  std::size_t first = 0;          ///< cycle of the first value, where this is a part of a recording
};

/// How far a chain's answer is from the recorded output where the output moves.
struct Residual {
  double delay_cycles = 0;  ///< of the recorded output behind the chain's
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
  double allowed_rms = 0;    ///< what rounding to these resolutions explains
  std::size_t compared = 0;  ///< cycles that count
  std::size_t lost = 0;
  /// What else the recording agrees with, best first: of a different one the explanation if it is a single one, of the
  /// same the readings that compute too similar numbers in this motion.
  std::vector<Explained> fitting{};
  std::optional<Explained> next{};  ///< the best that does not fit
};

/// The settings under which axisc computes what a recording shows: those of `current`, which the lists were compiled with,
/// changed by the one reading that fits. None where the recording does not tell, nothing fits, or the departure is none of the
/// arithmetic but of the values (a filter that was on or off).
[[nodiscard]] std::optional<design::Readings> settings_of(Comparison const& comparison,
                                                          design::Readings const& current);

/// Only the single best explanation may be believed: see `fitting`. Lags of up to 10 whole cycles, and fractions of a cycle
/// for the listed chain, are found. `all`: of readings(), the listed one first.
[[nodiscard]] Comparison compare(Recording const& recording, std::vector<Reading> const& all);

}  // namespace axisc::comparison
