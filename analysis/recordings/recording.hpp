// What a scope or a measuring program recorded, as its file has it.
//
// Channels that were sampled together share a clock. Clocks may have different sample times and begin at
// different times, so that channels are brought together by time, never by row (cycles.hpp).
#pragma once

#include "analysis/recordings/signal.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::recordings {

/// A field of a text that is not a number.
struct BadField {
  std::uint64_t line = 0;  ///< from 1
  std::string text = {};   ///< valid UTF-8 and not long
};

enum class ClockProblem : std::uint8_t {
  not_a_number,  ///< a time
  no_time,       ///< values without a time
  falls,         ///< a time is earlier than the one before
  two_values,    ///< different values at one time, as envelopes (minimum and maximum) have them
};

enum class TimeUnit : std::uint8_t { milliseconds, seconds };

struct Clock {
  Signal times = {};                       ///< strictly rising; none where is_counted
  Signal lines = {};                       ///< of the text, from 1; none of a binary file
  bool is_counted = false;                 ///< there are no times: one sample a row
  TimeUnit unit = TimeUnit::milliseconds;  ///< of `times`
  std::size_t samples = 0;
  std::size_t repeated = 0;  ///< samples that had the time and the values of the one before; they are dropped
  /// What the header says, ms.
  std::optional<double> sample_time = {};
  /// Samples end before it; who uses the clock has to refuse it.
  std::optional<ClockProblem> problem = {};
  BadField place = {};  ///< of the problem
};

/// shown = unit_factor (factor raw + offset) + unit_offset
struct Scale {
  double factor = 1, offset = 0, unit_factor = 1, unit_offset = 0;

  [[nodiscard]] bool is_identity() const {
    return factor == 1 && offset == 0 && unit_factor == 1 && unit_offset == 0;
  }
  [[nodiscard]] double shown(double raw) const { return unit_factor * (factor * raw + offset) + unit_offset; }
  [[nodiscard]] double raw(double shown) const {
    return ((shown - unit_offset) / unit_factor - offset) / factor;
  }
};

struct Channel {
  std::string name;                  ///< valid UTF-8, like all texts here
  std::size_t column = 0;            ///< of a text, from 1; the number of the channel in a binary file
  std::size_t clock = 0;             ///< index into Recording::clocks
  Signal values = {};                ///< one a sample of the clock; NaN: missing
  std::optional<BadField> bad = {};  ///< the first field that is neither a finite number nor empty
  std::string symbol = {};           ///< SymbolName
  std::string data_type = {};        ///< "INT32", "REAL64"; empty where the file does not say
  std::string unit = {};             ///< as the file has it, without blanks around it: "(None)", "mm"
  std::optional<std::uint64_t> port = {}, index_group = {}, index_offset = {};
  Scale scale = {};
  bool is_raw = false;  ///< the values are known to be raw, as in a binary file
};

enum class Form : std::uint8_t {
  scope_text,    ///< with a table that describes each channel
  columns,       ///< a line with names, or none
  scope_binary,  ///< .svdx
};

struct Recording {
  Form form = Form::columns;
  bool is_named = true;  ///< false: names are the numbers of the columns
  std::vector<Clock> clocks;
  std::vector<Channel> channels;
  std::vector<std::string> not_recorded = {};  ///< channels of a binary file without samples
};

}  // namespace axisc::recordings
