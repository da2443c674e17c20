// Blocks of an NC program with words that say how its path is driven, as the checks of AX8 read them.
#pragma once

#include "schema/motion_words.hpp"
#include "validator/engine/rule.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace axisc::validator {

/// G131=50, with the value where it is a number.
struct BlockFunction {
  int number = 0;
  schema::MotionWord const* word = nullptr;  ///< null for a function that says nothing about the motion
  Span span;
  std::size_t index = 0;  ///< among the words of the block
  std::optional<double> value;
  Span value_span;
};

/// X50 or X1=50.
struct BlockAxisWord {
  std::string_view axis;
  Span span;
  std::optional<double> value;
};

class MotionBlock {
 public:
  /// `text` is what the spans count in. Both outlive this.
  MotionBlock(grammar::WantedBlock const& block, std::string_view text) : words_(block.words), text_(text) {}

  [[nodiscard]] std::vector<BlockFunction> functions() const;
  /// The axis words behind a word.
  [[nodiscard]] std::vector<BlockAxisWord> axis_words_behind(std::size_t index) const;
  /// A word gives a destination, and the block is no dwell.
  [[nodiscard]] bool moves() const;
  /// The slope that the block puts in force: by type, by number, or `standard` with DEFAULT.
  [[nodiscard]] std::optional<machine::Slope> slope(machine::Slope standard) const;
  [[nodiscard]] bool names_slope() const;
  /// `#SLOPE [..]`, after which weights are of all accelerations and ramp times, and `#SLOPE DEFAULT`, after
  /// which P-CHAN-00001 and 00073 say of which.
  [[nodiscard]] bool weighs_all() const;
  [[nodiscard]] bool takes_default_slope() const;

 private:
  [[nodiscard]] std::string_view text(std::size_t index) const;
  [[nodiscard]] std::string_view next(std::size_t index) const;

  std::vector<grammar::Word> const& words_;
  std::string_view text_;
};

/// One of the programs that the channel runs has a word that chooses the slope.
[[nodiscard]] bool programs_choose_slope(GroupContext const& context);

}  // namespace axisc::validator
