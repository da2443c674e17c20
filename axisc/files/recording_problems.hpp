// What is wrong in a recording, in words.
#pragma once

#include "analysis/recordings/bad_recording.hpp"
#include "axisc/files/recording_file.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace axisc {

/// Printable, and not long.
[[nodiscard]] std::string shown_column(std::string_view name);

/// "scope.csv:12"; the file alone for line 0.
[[nodiscard]] std::string place_at(std::string const& file, std::uint64_t line);

// Failures (AX9005).

/// Of a file that is no recording.
[[noreturn]] void fail_reading(std::string const& file, recordings::BadRecording const& bad);
/// Of a value, or a time, that is not a number, in a column that is read.
[[noreturn]] void fail_value(RecordingFile const& file, std::size_t channel);
[[noreturn]] void fail_clock(RecordingFile const& file, std::size_t channel);
/// Of columns that do not give one value a cycle.
[[noreturn]] void fail_cycles(RecordingFile const& file, recordings::BadCycles const& bad, double cycle_ms);

}  // namespace axisc
