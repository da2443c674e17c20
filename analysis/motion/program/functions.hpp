// The G words of a program.
#pragma once

#include "analysis/motion/program/modal_words.hpp"
#include "diagnostics/sentence.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace axisc::motion {

/// What remains to be done for a G word.
enum class FunctionMeaning : std::uint8_t {
  nothing,      ///< already in force, or switches off what the simulation does not have
  dwell,        ///< the block gives its duration
  needs_tools,  ///< refused, as are the following
  needs_offsets,
  unknown,
};

/// Puts in force what the function asks for.
[[nodiscard]] FunctionMeaning take_function(int number, ModalWords& modal);
/// Why a function is refused.
[[nodiscard]] SentenceRef refusal_of(FunctionMeaning meaning);

/// G words of one group exclude each other, so that a block has at most one of them.
class ChosenFunctions {
 public:
  /// False where another word of the block excludes it.
  [[nodiscard]] bool choose(int number);

 private:
  static constexpr std::size_t group_count = 8;
  std::array<std::optional<int>, group_count> chosen_{};
};

}  // namespace axisc::motion
