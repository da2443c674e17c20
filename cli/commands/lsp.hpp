// `axisc lsp`, whose server the page uses without its streams.
#pragma once

#include "cli/commands/commands.hpp"
#include "editor/session.hpp"

#include <memory>

namespace axisc::cli {

/// The session that the arguments of `axisc lsp` ask for; none if they ask for the help, which is printed.
/// Failure for invalid ones.
[[nodiscard]] std::unique_ptr<editor::Session> editor_session(Invocation const& invocation);

}  // namespace axisc::cli
