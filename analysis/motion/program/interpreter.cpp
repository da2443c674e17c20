#include "analysis/motion/program/interpreter.hpp"

#include <utility>

namespace axisc::motion {

ProgramInterpreter::ProgramInterpreter(ProgramChannel channel, PathListener& listener,
                                       std::function<void(ProgramProblem)> problem)
    : state_{.channel = std::move(channel),
             .listener = listener,
             .problems = ProgramProblems(std::move(problem))},
      flow_(state_),
      reader_(*this, grammar::ProgramDetail::words) {
  state_.modal.inch = state_.channel.inch;
  state_.modal.weighted_acceleration = state_.channel.dynamics.weighted_acceleration;
  state_.modal.weighted_ramp = state_.channel.dynamics.weighted_ramp;
}

bool ProgramInterpreter::line(std::string_view text, std::uint32_t offset) {
  if (state_.ended) return false;
  keep(text, offset);
  reader_.line(text, offset);
  next_block();
  return !state_.ended;
}

void ProgramInterpreter::finish() {
  if (state_.ended) return;
  reader_.finish();
  next_block();
  flow_.finish();
  if (!state_.ended) state_.end();
}

/// Keeps the offsets of the program: lines are as many bytes apart as there.
void ProgramInterpreter::keep(std::string_view text, std::uint32_t offset) {
  if (reader_.block_is_open()) {
    lines_.resize(offset - offset_, '\n');
  } else {
    lines_.clear();
    offset_ = offset;
  }
  lines_ += text;
}

void ProgramInterpreter::word(grammar::Word const& word) {
  tokens_.push_back({.kind = word.kind, .span = word.span, .line = word.line, .command = std::nullopt});
}

void ProgramInterpreter::command(grammar::NcCommand command) {
  tokens_.push_back({.kind = grammar::WordKind::other,
                     .span = command.name,
                     .line = command.line,
                     .command = commands_.size()});
  commands_.push_back(std::move(command));
}

/// The block that was read so far is complete.
void ProgramInterpreter::next_block() {
  if (tokens_.empty()) return;
  flow_.next(
      {.lines = lines_, .offset = offset_, .tokens = tokens_, .commands = commands_, .is_kept = false});
  tokens_.clear();
  commands_.clear();
}

}  // namespace axisc::motion
