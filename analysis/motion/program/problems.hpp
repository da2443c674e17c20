// Places of a program that a simulation does not follow, as findings.
#pragma once

#include "analysis/motion/program/nc_block.hpp"
#include "analysis/motion/program/sentences.hpp"
#include "diagnostics/finding.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace axisc::motion {

/// A place that the simulation does not follow.
struct ProgramProblem {
  Finding finding;  ///< without place
  std::uint32_t line = 0;
  std::string line_text;  ///< the whole line
  Span span;              ///< in it
};

/// One mistake gives one message: once something in a block is refused, the rest of the block is skipped.
class ProgramProblems {
 public:
  explicit ProgramProblems(std::function<void(ProgramProblem)> sink) : sink_(std::move(sink)) {}

  /// A mistake in a #FILTER command.
  void report(NcBlock const& block, Token const& token, Code code, Message message);
  /// AX9007, once for each key.
  void ignore(NcBlock const& block, Token const& token, std::string const& key, SentenceRef text,
              std::vector<Argument> arguments = {});
  /// AX9007 at the end of the program, unless used() has said by then that a word of this kind counts.
  void ignore_unless_used(NcBlock const& block, Token const& token, std::string const& key, SentenceRef text);
  void used() { used_ = true; }
  void finish();
  /// AX9008.
  void refuse(NcBlock const& block, Token const& token, SentenceRef text = says::cannot_simulate);

  void begin_block() { refused_ = false; }
  /// Something in the block was refused.
  [[nodiscard]] bool refused() const { return refused_; }
  /// Something in a loop or a subprogram was refused: its blocks are not executed any more.
  [[nodiscard]] bool broken() const { return broken_; }

 private:
  std::function<void(ProgramProblem)> sink_;
  std::set<std::string> ignored_;
  std::optional<ProgramProblem> later_;
  std::string later_key_;
  bool used_ = false;
  bool refused_ = false;
  bool broken_ = false;
};

}  // namespace axisc::motion
