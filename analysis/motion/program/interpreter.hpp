// Interprets the path of an NC program, in the subset that a simulation follows; docs/nc-programs.md has the
// table.
//
// Words outside of it become problems: those that change neither path nor filters are ignored, at their first
// place with a warning (AX9007); all others are refused (AX9008).
#pragma once

#include "analysis/motion/path_listener.hpp"
#include "analysis/motion/program/channel.hpp"
#include "analysis/motion/program/flow.hpp"
#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/problems.hpp"
#include "analysis/motion/program/state.hpp"
#include "grammar/nc_program.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::motion {

class ProgramInterpreter final : private grammar::ProgramListener {
 public:
  /// The listener must outlive this.
  ProgramInterpreter(ProgramChannel channel, PathListener& listener,
                     std::function<void(ProgramProblem)> problem);
  ProgramInterpreter(ProgramInterpreter const&) = delete;
  ProgramInterpreter& operator=(ProgramInterpreter const&) = delete;
  ~ProgramInterpreter() override = default;

  /// The next line without its line end; `offset` is its place in the program. False after the end of the
  /// program.
  bool line(std::string_view text, std::uint32_t offset);
  /// After the last line.
  void finish();
  /// By how many mm the control rounds corners at most that were followed as they are; none where it rounds
  /// none.
  [[nodiscard]] std::optional<double> rounding() const { return state_.rounding; }

 private:
  void word(grammar::Word const& word) override;
  void command(grammar::NcCommand command) override;
  void directive(grammar::Directive const& /*directive*/) override {}

  void keep(std::string_view text, std::uint32_t offset);
  void next_block();

  ProgramState state_;
  ProgramFlow flow_;
  grammar::ProgramReader reader_;
  std::string lines_;  ///< of the block that is being read
  std::uint32_t offset_ = 0;
  std::vector<Token> tokens_;
  std::vector<grammar::NcCommand> commands_;
};

}  // namespace axisc::motion
