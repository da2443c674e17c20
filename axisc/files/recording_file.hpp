// A file with a recording; mistakes in it are Failures with their place.
#pragma once

#include "analysis/recordings/cycles.hpp"
#include "analysis/recordings/recording.hpp"
#include "analysis/recordings/text_lines.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axisc {

struct RecordingFile {
  std::string name;  ///< in messages
  recordings::Recording recording;

  /// By name, by the control's symbol, or by number from 1. Failure (AX9005) where there is none, and where
  /// several have the name and different values.
  [[nodiscard]] std::size_t channel_named(std::string const& wanted) const;
  /// "a", "b": names of channels, for messages.
  [[nodiscard]] std::string known(std::span<std::size_t const> channels) const;
  [[nodiscard]] std::string known() const;
  /// "scope.csv:12", where the clock of a channel has this sample, or the name of a file without lines.
  [[nodiscard]] std::string place(std::size_t channel, std::optional<std::size_t> sample) const;
};

/// Any form of analysis/recordings/recording_reader.hpp. `name` is the file in messages. Failure (AX9005) for
/// a file that is not a recording.
[[nodiscard]] RecordingFile read_recording_file(std::string name, recordings::ByteSource source);
/// Failure AX9001 for a file that cannot be read.
[[nodiscard]] RecordingFile open_recording(std::string const& path);

/// One value a cycle of `cycle_ms`. Failure (AX9005) where the recording does not have them.
[[nodiscard]] recordings::CycleSignals cycles_of(RecordingFile const& file,
                                                 std::span<std::size_t const> channels, double cycle_ms);

/// Both have the same samples, as a channel and its copy have.
[[nodiscard]] bool are_equal(recordings::Recording const& recording, std::size_t a, std::size_t b);

}  // namespace axisc
