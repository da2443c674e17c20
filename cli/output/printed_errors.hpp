// Errors that prevent a machine or stop a program, as `lint` prints them.
#pragma once

#include "axisc/answers/simulation/followed_program.hpp"
#include "axisc/checking/machine_input.hpp"
#include "cli/options/invocation.hpp"

#include <functional>

namespace axisc::cli {

/// Print them on standard error.
[[nodiscard]] ErrorSink printed_errors(Invocation const& invocation, bool color);
[[nodiscard]] TakeProblem printed_problems(Invocation const& invocation, bool color);
/// Prints a warning on standard error.
[[nodiscard]] std::function<void(Message const&)> printed_remarks(Invocation const& invocation);
/// "axisc: …" on standard error.
[[nodiscard]] std::function<void(Message const&)> printed_notes(Invocation const& invocation);

}  // namespace axisc::cli
