// Help for the #FILTER commands of NC programs.
#pragma once

#include "diagnostics/sentence.hpp"
#include "schema/motion_words.hpp"
#include "validator/loading/loading.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::editor {

struct CommandHelp {
  std::string text;  ///< Markdown that is also readable as plain text
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The effect of the command at a byte, with the kernel of each axis of the machine; none if there is no
/// command, or if it is wrong or depends on variables. Loops and calls are not followed: commands apply in
/// the order of the text.
[[nodiscard]] std::optional<CommandHelp> command_help(std::string_view text, std::size_t offset,
                                                      validator::LoadedMachine const* machine,
                                                      Language language);

/// A word that says how a path is driven, where it stands.
struct MotionWordPlace {
  schema::MotionWord const* word = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The word at a byte of a program; none for all others.
[[nodiscard]] std::optional<MotionWordPlace> motion_word_at(std::string_view text, std::size_t offset);

/// Commands, switches and keywords that can continue a line, given its text up to the cursor.
[[nodiscard]] std::vector<std::string> command_words(std::string_view typed);

}  // namespace axisc::editor
