// Executes the words of a block, one after the other.
#pragma once

#include "analysis/motion/program/block_dwell.hpp"
#include "analysis/motion/program/block_motion.hpp"
#include "analysis/motion/program/functions.hpp"
#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/state.hpp"
#include "schema/motion_words.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace axisc::motion {

/// The effects of a block on the flow of the program.
struct BlockOutcome {
  std::optional<std::size_t> call;  ///< the word LL of a call
  bool returns = false;             ///< the subprogram ends here (M17, M29)
};

/// Executes one block, once. Both arguments outlive this.
class BlockWords {
 public:
  BlockWords(NcBlock const& block, ProgramState& state, bool in_subprogram)
      : block_(block),
        state_(state),
        motion_(block, state),
        dwell_(block, state),
        in_subprogram_(in_subprogram) {}

  BlockOutcome execute();

 private:
  std::size_t take(std::size_t at);
  std::size_t take_address(std::size_t at);
  std::size_t take_assignment(std::size_t at);
  std::size_t take_call(std::size_t at);
  std::size_t take_command(std::size_t at);
  std::size_t take_g(std::size_t at, std::string_view digits);
  std::size_t take_motion_word(schema::MotionWord const& word, std::size_t at);
  std::size_t take_value_of(schema::MotionWord const& word, std::size_t at);
  void weigh(Token const& token, schema::Weighting const& weighting, std::size_t axis, double percent);
  void set_look_ahead(unsigned functions);
  void take_m(Token const& token, std::string_view digits);
  void take_value(Token const& token, std::string_view name, double value);
  void refuse(Token const& token, SentenceRef text = says::cannot_simulate);

  NcBlock const& block_;
  ProgramState& state_;
  BlockMotion motion_;
  BlockDwell dwell_;
  ChosenFunctions chosen_;
  std::optional<schema::Weighting> weighting_;  ///< axis words are percentages from here on
  bool in_subprogram_;
  BlockOutcome outcome_;
};

}  // namespace axisc::motion
