// The running program and its standard streams.
#pragma once

#include "system/error.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::system {

enum class Stream : std::uint8_t { output = 1, error = 2 };

/// Called once at the start: a closed pipe and a file beyond the user's limit are errors of write() from then
/// on, and standard input, output and error are open, so that no file takes the place of one that the caller
/// closed.
void prepare_streams();
/// Memory that one input needed waits for the next one instead of going back to the system, which would hand
/// it out again page by page: as much time as to read a list.
void keep_memory();

[[nodiscard]] bool is_terminal(Stream stream);
/// Columns of the terminal that standard output is; none elsewhere.
[[nodiscard]] std::optional<std::size_t> terminal_width();
/// Writes all of `bytes`.
[[nodiscard]] std::optional<Error> write(Stream stream, std::string_view bytes);

/// Empty when it is not set.
[[nodiscard]] std::string_view environment_variable(char const* name);

/// The user's language in the system's settings, "de"; empty where only variables of the environment define
/// it.
[[nodiscard]] std::string_view language_of_settings();

/// Whether the shell replaces `*.lis` by the names that match it.
[[nodiscard]] bool shell_expands_patterns();

/// Unique among all running processes, on every host: number of the process and name of the host.
struct ProcessName {
  std::uint64_t number = 0;
  std::string host;
};
[[nodiscard]] ProcessName process_name();

}  // namespace axisc::system
