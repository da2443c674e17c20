#include "analysis/motion/program/flow.hpp"

#include "analysis/motion/program/block_words.hpp"
#include "analysis/motion/program/loops.hpp"

#include <string_view>
#include <utility>

namespace axisc::motion::says {

constexpr Sentence cannot_simulate_endless{
    "`{word}`: the repetition does not end within the blocks that the simulation executes",
    "`{word}`: die Wiederholung endet nicht innerhalb der Sätze, die die Simulation ausführt"};
constexpr Sentence cannot_simulate_call{
    "`{word}`: the program has no such subprogram (%L) before this place",
    "`{word}`: das Programm hat vor dieser Stelle kein solches Unterprogramm (%L)"};

}  // namespace axisc::motion::says

namespace axisc::motion {
namespace {

constexpr int deepest = 40;

}  // namespace

void ProgramFlow::next(NcBlock const& block) {
  auto const at = block.first_word();
  bool const is_empty = at == block.tokens.size();
  if (!is_empty && block.tokens[at].kind == grammar::WordKind::program) {
    if (subprograms_.begin(block, !loop_.empty())) return;
  } else if (!is_empty && (subprograms_.keep(block) || keep_in_loop(block))) {
    return;
  }
  execute(block);
}

/// A loop is executed when its last block was read.
bool ProgramFlow::keep_in_loop(NcBlock const& block) {
  auto const control = block.control();
  bool const begins = loop_.empty() && conditions_.is_active() && opens_loop(control);
  if (!begins && loop_.empty()) return false;
  if (opens_loop(control)) ++loop_depth_;
  if (closes_loop(control)) --loop_depth_;
  loop_.emplace_back(block);
  if (loop_depth_ > 0) return true;
  auto const loop = std::exchange(loop_, {});
  run(loop);
  leaves_ = Leaves::nothing;
  return true;
}

void ProgramFlow::execute(NcBlock const& block) {
  if (conditions_.take(block) || !conditions_.is_active()) return;
  if (!block.control().empty()) return take_control(block);
  auto const outcome = BlockWords(block, state_, calls_ > 0).execute();
  if (outcome.returns) leaves_ = Leaves::subprogram;
  if (outcome.call) call(block, *outcome.call);
}

void ProgramFlow::take_control(NcBlock const& block) {
  auto const word = block.control();
  if (word == "$BREAK" && loops_ > 0) {
    leaves_ = Leaves::loop;
  } else if (word == "$CONTINUE" && loops_ > 0) {
    leaves_ = Leaves::round;
  } else {
    refuse(block, says::cannot_simulate_here);
  }
}

/// LL NAME
void ProgramFlow::call(NcBlock const& block, std::size_t at) {
  std::string_view name;
  if (at + 1 < block.tokens.size()) {
    name = block.text(Span{.begin = block.tokens[at + 1].span.begin, .end = block.tokens.back().span.end});
  }
  Token const& word = block.tokens[at];
  auto const* const subprogram = subprograms_.find(name);
  if (subprogram == nullptr) return state_.problems.refuse(block, word, says::cannot_simulate_call);
  if (depth_ >= deepest) return state_.problems.refuse(block, word, says::cannot_simulate_depth);
  ++calls_;
  auto const loops = std::exchange(loops_, 0);
  run(*subprogram);
  loops_ = loops;
  --calls_;
  leaves_ = Leaves::nothing;
}

void ProgramFlow::run(KeptBlocks blocks) {
  auto const open = conditions_.open_count();
  ++depth_;
  for (std::size_t i = 0; i < blocks.size() && goes_on() && leaves_ == Leaves::nothing;) {
    auto const block = blocks[i].block();
    if (!conditions_.is_active() || !opens_loop(block.control())) {
      repeat(block);
      ++i;
      continue;
    }
    if (depth_ > deepest) refuse(block, says::cannot_simulate_depth);
    auto const size = loop_size(blocks.subspan(i));
    if (size == 0) {
      refuse(block, says::cannot_simulate_open);
    } else if (goes_on()) {
      run_loop(blocks.subspan(i, size));
    }
    i += size;
  }
  --depth_;
  if (conditions_.open_count() > open && leaves_ == Leaves::nothing && goes_on()) conditions_.refuse_open();
  conditions_.close_to(open);
}

/// From the block that opens a loop to the one that closes it.
void ProgramFlow::run_loop(KeptBlocks loop) {
  auto const opening = loop.front().block();
  auto const closing = loop.back().block();
  LoopRounds rounds(opening, closing, state_.variables, state_.problems);
  rounds.check();
  while (goes_on()) {
    count_repeated(opening);
    if (!goes_on() || !rounds.begins()) return;
    ++loops_;
    run(loop.subspan(1, loop.size() - 2));
    --loops_;
    if (leaves_ == Leaves::subprogram || !goes_on()) return;
    if (std::exchange(leaves_, Leaves::nothing) == Leaves::loop) return;
    if (!rounds.goes_on()) return;
  }
}

void ProgramFlow::repeat(NcBlock const& block) {
  count_repeated(block);
  if (goes_on()) execute(block);
}

void ProgramFlow::count_repeated(NcBlock const& block) {
  if (++repeated_ == state_.channel.most_repeated_blocks) {
    state_.problems.refuse(block, block.tokens.front(), says::cannot_simulate_endless);
  }
}

void ProgramFlow::finish() {
  if (state_.ended) return;
  if (subprograms_.is_open()) {
    // Nothing follows: the program would be empty.
    subprograms_.refuse_open();
  } else if (!loop_.empty()) {
    refuse(loop_.front().block(), says::cannot_simulate_open);
  } else if (conditions_.open_count() > 0) {
    conditions_.refuse_open();
  }
}

void ProgramFlow::refuse(NcBlock const& block, SentenceRef text) {
  state_.problems.refuse(block, block.tokens[block.first_word()], text);
}

}  // namespace axisc::motion
