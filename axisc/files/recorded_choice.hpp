// Which column of a recording is which signal of an axis.
//
// A column is found, in this order: by the option that names it; by its object
// (analysis/recordings/objects.hpp); by the control's name of the object, or the name that a template gives
// it ("X filtered"); and in a text without a scope's header by its place, where there are as many columns as
// signals.
#pragma once

#include "analysis/recordings/objects.hpp"
#include "axisc/files/recording_file.hpp"
#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// Where a control has an axis.
struct AxisPlace {
  std::string name;           ///< as people see it
  std::uint32_t channel = 0;  ///< from 1; 0: not known
  std::uint32_t index = 0;    ///< in the channel, from 1; 0: not known, the axis is the only one
  std::uint32_t number = 0;   ///< of the axis (P-AXIS-00016); 0: not known
};

/// `in_machine` is false for a list by itself, of which nobody knows where its control has it.
[[nodiscard]] AxisPlace axis_place(machine::Machine const& machine, std::size_t axis, bool in_machine);

enum class FoundBy : std::uint8_t { option, object, name, order };

struct ChosenColumn {
  std::size_t channel = 0;  ///< index into Recording::channels
  FoundBy by = FoundBy::order;
  std::optional<recordings::RecognisedObject> object = {};  ///< that it is, however it was found
};

/// A signal that is wanted.
struct WantedSignal {
  recordings::Object object = recordings::Object::position_unfiltered;
  std::string_view option;                 ///< "--in"
  std::optional<std::string> column = {};  ///< that the option names, by name or number
};

/// The column of each signal. Failure (AX9005) that lists what there is where one is not found, or several
/// are.
[[nodiscard]] std::vector<ChosenColumn> choose_columns(RecordingFile const& file, AxisPlace const& axis,
                                                       std::vector<WantedSignal> const& wanted);

/// The column of one signal, by object or name alone; none where there is none. Failure where there are
/// several with different values.
[[nodiscard]] std::optional<ChosenColumn> find_column(RecordingFile const& file, AxisPlace const& axis,
                                                      recordings::Object object, std::string_view option);

/// The channel with that name.
[[nodiscard]] ChosenColumn named_column(RecordingFile const& file, std::string const& wanted);

/// Axes of the machine whose filters the recording shows: that have an object of `objects` in it, by group
/// and offset.
[[nodiscard]] std::vector<std::size_t> recorded_axes(RecordingFile const& file,
                                                     machine::Machine const& machine,
                                                     std::vector<recordings::Object> const& objects);

}  // namespace axisc
