#include "analysis/motion/program/subprograms.hpp"

#include "analysis/motion/program/loops.hpp"

#include <algorithm>

namespace axisc::motion {

bool ProgramSubprograms::begin(NcBlock const& block, bool in_loop) {
  Token const& token = block.tokens[block.first_word()];
  std::string_view name = block.text(token);
  open_ = nullptr;
  bool const is_subprogram = name == "%L" || name.starts_with("%L ") || name.starts_with("%L\t");
  if (!is_subprogram) return false;
  name.remove_prefix(2);
  name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
  if (in_loop || name.empty()) {
    problems_.refuse(block, token);
    return true;
  }
  open_ = &blocks_[std::string(name)];
  open_->clear();
  opening_.emplace(block);
  depth_ = 0;
  return true;
}

bool ProgramSubprograms::keep(NcBlock const& block) {
  if (open_ == nullptr) return false;
  open_->emplace_back(block);
  auto const control = block.control();
  if (control == "$IF" || opens_loop(control)) ++depth_;
  if (control == "$ENDIF" || closes_loop(control)) --depth_;
  bool const ends = std::any_of(block.tokens.begin(), block.tokens.end(), [&block](Token const& token) {
    auto const word = block.text(token);
    return token.kind == grammar::WordKind::address && (word == "M17" || word == "M29");
  });
  // In a condition it is not the last block.
  if (ends && depth_ <= 0) open_ = nullptr;
  return true;
}

std::vector<KeptBlock> const* ProgramSubprograms::find(std::string_view name) const {
  auto const found = blocks_.find(name);
  return found == blocks_.end() ? nullptr : &found->second;
}

void ProgramSubprograms::refuse_open() {
  auto const block = opening_->block();
  problems_.refuse(block, block.tokens[block.first_word()], says::cannot_simulate_open);
}

}  // namespace axisc::motion
