// A scope's recording of the command positions of a channel's axes before their filters.
#pragma once

#include "axisc/files/recorded_signals.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace axisc {

/// The column of an axis, by name or number: `--in X=setpoint`.
struct AxisColumn {
  std::string axis, column;
};

struct RecordedPositions {
  std::vector<std::size_t> axes;  ///< of the channel: those of the signals
  RecordedSignals recorded;
};

/// Columns that are not named are those called like an axis, in small letters or capitals; where the channel
/// has one axis, the only column that is no time. Failure (AX9005) where no axis has a column, and as
/// those of read_recorded_signals(); Failure for a named axis that the channel does not have.
[[nodiscard]] RecordedPositions read_recorded_positions(std::string const& file,
                                                        recordings::ByteSource source,
                                                        std::vector<std::string> const& axes,
                                                        std::vector<AxisColumn> const& named,
                                                        design::CycleTime cycle_time);

}  // namespace axisc
