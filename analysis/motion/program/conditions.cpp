#include "analysis/motion/program/conditions.hpp"

namespace axisc::motion {
namespace {

constexpr std::size_t most_open_conditions = 80;

}  // namespace

bool ProgramConditions::take(NcBlock const& block) {
  auto const word = block.control();
  auto const at = block.first_word();
  if (word == "$IF") {
    open(block, at);
    return true;
  }
  bool const branches = word == "$ELSE" || word == "$ELSEIF" || word == "$ENDIF";
  if (!branches || open_.empty()) return false;
  if (word == "$ENDIF") {
    open_.pop_back();
    return true;
  }
  auto& condition = open_.back();
  condition.holds =
      !condition.held && (word == "$ELSE" || variables_.value_behind(at, block, problems_) != 0);
  condition.held = condition.held || condition.holds;
  return true;
}

void ProgramConditions::open(NcBlock const& block, std::size_t at) {
  if (open_.size() >= most_open_conditions) {
    return problems_.refuse(block, block.tokens[at], says::cannot_simulate_depth);
  }
  bool const outer = is_active();
  bool const holds = outer && variables_.value_behind(at, block, problems_) != 0;
  open_.push_back({.holds = holds, .held = holds || !outer, .opening = KeptBlock(block)});
}

void ProgramConditions::refuse_open() {
  auto const block = open_.back().opening.block();
  problems_.refuse(block, block.tokens[block.first_word()], says::cannot_simulate_open);
}

void ProgramConditions::close_to(std::size_t count) {
  while (open_.size() > count) open_.pop_back();
}

}  // namespace axisc::motion
