// The commands of NC programs, `#NAME …`, with a span for each token. The grammar knows how a command is
// written, not which keywords it has or what they mean.
#pragma once

#include "diagnostics/span.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace axisc::grammar {

enum class CommandKind : std::uint8_t {
  filter,           ///< #FILTER
  vibration_guard,  ///< #VIB GUARD
  axis_exchange,    ///< #CALL AX, #PUT AX, #SET AX (but not #SET AX LINK, which exchanges nothing)
  other,            ///< any other command; nothing but its first word has been read
};

enum class CommandSwitch : std::uint8_t { none, on, off };

enum class KeywordValue : std::uint8_t {
  none,       ///< no `=` after the name: HSC
  missing,    ///< nothing after `=`
  integer,    ///< 20, +5, -5, 020
  real,       ///< 0.5, .5, 5., 1e3
  variable,   ///< P10, V.P.ORDER, V.L.TABLE[2]: known only while the program runs
  malformed,  ///< anything else: 2O, 0,5
};

struct Keyword {
  Span name;
  KeywordValue kind = KeywordValue::none;
  Span value;  ///< empty for `none` and `missing`
};

enum class CommandProblemKind : std::uint8_t {
  letter_case,       ///< the command's name is not written in upper case; span is the name
  unexpected_text,   ///< neither ON, OFF nor `[`, or text after the command
  expected_keyword,  ///< something else inside the brackets
  unclosed_bracket,  ///< span is the `[`
};

/// The first place where a command is not written as it should be.
struct CommandProblem {
  CommandProblemKind kind{};
  Span span;
};

/// #FILTER and #VIB GUARD with everything that could be read, also where there is a problem; of other
/// commands the name.
struct NcCommand {
  CommandKind kind = CommandKind::other;
  Span name;  ///< `#FILTER`, `#VIB GUARD`, `#CALL AX`
  CommandSwitch command_switch = CommandSwitch::none;
  std::vector<Keyword> keywords;
  std::optional<CommandProblem> problem;
  /// Of kind `other`: the words that begin or end like `#FILTER` or `#VIB GUARD` and may be one of them,
  /// misspelt: `#FILTR`, `# FILTER`, `#VIB_GUARD`. Else empty.
  Span resembling;
  std::uint32_t line = 0;  ///< of the name, from 1
};

/// False for a command that is neither read nor may be a misspelt one of those that are.
[[nodiscard]] inline bool is_of_interest(NcCommand const& command) {
  return command.kind != CommandKind::other || !command.resembling.empty();
}

/// The text of one command, "#FILTER ON [ORDER=20]", with nothing but blanks and comments around it; none
/// where the text begins with anything else. Spans count from the start of `text`.
[[nodiscard]] std::optional<NcCommand> parse_nc_command(std::string_view text);

/// The command whose `#` is at `position` of a block; its spans count from `offset` more. Afterwards
/// `position` is after the command, or where it is not written as it should be.
[[nodiscard]] NcCommand read_nc_command(std::string_view block, std::size_t& position, std::uint32_t offset);

}  // namespace axisc::grammar
