#include "analysis/motion/program/nc_block.hpp"

namespace axisc::motion {

using grammar::WordKind;

std::string_view NcBlock::text(Span span) const {
  return lines.substr(span.begin - offset, span.size());
}

std::size_t NcBlock::first_word() const {
  std::size_t at = 0;
  while (at < tokens.size() &&
         (tokens[at].kind == WordKind::skip || tokens[at].kind == WordKind::block_number)) {
    ++at;
  }
  return at;
}

std::string_view NcBlock::control() const {
  auto const at = first_word();
  bool const is_control = at < tokens.size() && tokens[at].kind == WordKind::control;
  return is_control ? text(tokens[at]) : std::string_view();
}

KeptBlock::KeptBlock(NcBlock const& block)
    : lines_(block.lines),
      offset_(block.offset),
      tokens_(block.tokens.begin(), block.tokens.end()),
      commands_(block.commands.begin(), block.commands.end()) {}

NcBlock KeptBlock::block() const {
  return {.lines = lines_, .offset = offset_, .tokens = tokens_, .commands = commands_, .is_kept = true};
}

}  // namespace axisc::motion
