// Failures about rows of numbers.
#pragma once

#include "analysis/recordings/number_rows.hpp"

#include <string>

namespace axisc {

/// The Failure (AX9005) for rows.problem(); `file` is the name in the message.
[[noreturn]] void fail_row(recordings::NumberRows const& rows, std::string const& file);

/// A name of a column for a message: valid UTF-8, not long.
[[nodiscard]] std::string shown_column(std::string_view name);

/// False at the end; Failure (AX9005) for a bad row.
[[nodiscard]] bool next_row(recordings::NumberRows& rows, std::span<double> row, std::string const& file);

}  // namespace axisc
