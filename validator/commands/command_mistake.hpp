// Shared by the checks of commands: codes, the commands' names, and how a mistake begins.
#pragma once

#include "validator/commands/command_check.hpp"

#include <string_view>
#include <vector>

namespace axisc::validator {

inline constexpr Code syntax_mistake{5001};
inline constexpr Code keyword_mistake{5002};
inline constexpr Code without_oscillation{3026};

/// "#FILTER", "#VIB GUARD".
[[nodiscard]] std::string_view proper_name(grammar::CommandKind kind);
/// How the command is written.
[[nodiscard]] Message syntax_of(grammar::CommandKind kind);

/// Adds a mistake of a command; one of syntax with the syntax as note.
CommandMistake& add_mistake(CheckedCommand& checked, grammar::CommandKind kind, Code code, Span span,
                            SentenceRef text, std::vector<Argument> arguments = {});

[[nodiscard]] inline std::string_view slice(std::string_view text, Span span) {
  return text.substr(span.begin, span.size());
}

}  // namespace axisc::validator
