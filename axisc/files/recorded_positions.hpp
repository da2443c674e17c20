// A scope's recording of the command positions of a channel's axes before their filters.
#pragma once

#include "axisc/files/recorded_choice.hpp"
#include "axisc/files/recording_file.hpp"
#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// The column of an axis, by name or number: `--in X=setpoint`.
struct AxisColumn {
  std::string axis, column;
};

/// "X=COLUMN" each. Failure for other texts, which names `option`.
[[nodiscard]] std::vector<AxisColumn> axis_columns(std::string const& option,
                                                   std::vector<std::string> const& texts);

/// The first column of that name, in small letters or capitals, a unit behind it or not.
[[nodiscard]] std::optional<ChosenColumn> column_called(RecordingFile const& file, std::string_view name);

struct RecordedPositions {
  std::vector<std::size_t> axes;      ///< of the channel: those of the signals
  std::vector<ChosenColumn> columns;  ///< of the axes
  recordings::CycleSignals recorded;  ///< in the units of the file
};

/// Columns that are not named are those of the axes' objects, as in recorded_choice.hpp, or called like an
/// axis, in small letters or capitals; where the channel has one axis, the only column. Failure (AX9005)
/// where no axis has a column; Failure for a named axis that the channel does not have.
[[nodiscard]] RecordedPositions read_recorded_positions(RecordingFile const& file,
                                                        machine::Machine const& machine, std::size_t group,
                                                        bool in_machine,
                                                        std::vector<AxisColumn> const& named);

}  // namespace axisc
