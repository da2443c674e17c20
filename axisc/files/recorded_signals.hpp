// Signals that a scope recorded together, a value a cycle.
#pragma once

#include "analysis/comparison/signal.hpp"
#include "analysis/recordings/text_lines.hpp"
#include "design/units.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace axisc {

struct ColumnNames {
  std::string const& file;  ///< in messages
  std::vector<std::string> const& names;
  std::vector<bool> is_time;

  /// By name, or by number from 1. Failure (AX9005) where there is none.
  [[nodiscard]] std::size_t index_of(std::string const& wanted) const;
  /// Those that are no time.
  [[nodiscard]] std::vector<std::size_t> values() const;
  /// For messages.
  [[nodiscard]] std::string known() const;
};

/// Picks the columns of the signals; may fail with a Failure.
using ChooseColumns = std::function<std::vector<std::size_t>(ColumnNames const&)>;

struct RecordedSignals {
  std::vector<std::string> names;
  std::vector<comparison::Signal> signals;
  std::vector<std::size_t> gaps;  ///< cycles that were lost, by the column of the time, and are interpolated
  std::size_t repeated = 0;       ///< rows that were recorded twice and are left out
};

/// Rows as in analysis/recordings/number_rows.hpp. A column whose name begins with "time" or "zeit" is the
/// time of the columns after it, in ms unless the name ends in "_s" or "[s]"; without names the first of
/// three columns, and the first of each pair of four. That of the first signal counts. `name` is the file in
/// messages. Failure (AX9005) for a mistake, also where more than a quarter of the cycles is lost.
[[nodiscard]] RecordedSignals read_recorded_signals(std::string const& name, recordings::ByteSource source,
                                                    ChooseColumns const& choose,
                                                    design::CycleTime cycle_time);

}  // namespace axisc
