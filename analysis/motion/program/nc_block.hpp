// A block of an NC program as it was read: its text, its words and commands.
#pragma once

#include "grammar/nc_program.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::motion {

/// A word or a command of a block.
struct Token {
  grammar::WordKind kind{};
  Span span;  ///< in the program
  std::uint32_t line = 0;
  std::optional<std::size_t> command;  ///< index into the block's commands
};

/// A view of a block that is stored elsewhere.
struct NcBlock {
  std::string_view lines;    ///< the lines that it lies on
  std::uint32_t offset = 0;  ///< of the first of them in the program
  std::span<Token const> tokens;
  std::span<grammar::NcCommand const> commands;
  bool is_kept = false;  ///< belongs to a loop or a subprogram

  [[nodiscard]] std::string_view text(Span span) const;
  [[nodiscard]] std::string_view text(Token const& token) const { return text(token.span); }
  /// After the optional prefix of every block: `/` and N10.
  [[nodiscard]] std::size_t first_word() const;
  /// `$IF` where the block begins with it, or nothing.
  [[nodiscard]] std::string_view control() const;
};

/// A block that is executed later, or more than once.
class KeptBlock {
 public:
  explicit KeptBlock(NcBlock const& block);
  /// Valid as long as this.
  [[nodiscard]] NcBlock block() const;

 private:
  std::string lines_;
  std::uint32_t offset_ = 0;
  std::vector<Token> tokens_;
  std::vector<grammar::NcCommand> commands_;
};

using KeptBlocks = std::span<KeptBlock const>;

}  // namespace axisc::motion
