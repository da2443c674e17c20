#include "grammar/program_excerpt.hpp"

namespace axisc::grammar {

std::size_t ProgramExcerptReader::collected() const {
  NcProgram const& program = collector_.program;
  return program.commands.size() + program.blocks.size() + program.directives.size();
}

void ProgramExcerptReader::line(std::string_view text) {
  std::size_t const before = collected();
  std::uint32_t const number = ++collector_.program.lines;
  // Spans count as if the line were kept; where it is not, none points into it.
  reader_.line(text, static_cast<std::uint32_t>(bytes_.size()));
  bool const is_found = collected() != before;
  if (!is_found && !reader_.block_is_open()) {
    bytes_.resize(kept_bytes_);
    numbers_.resize(kept_lines_);
    return;
  }
  bytes_ += text;
  bytes_ += '\n';
  numbers_.push_back(number);
  if (!is_found) return;
  kept_bytes_ = bytes_.size();
  kept_lines_ = numbers_.size();
}

void ProgramExcerptReader::finish() {
  std::size_t const before = collected();
  reader_.finish();
  if (collected() != before) return;
  bytes_.resize(kept_bytes_);
  numbers_.resize(kept_lines_);
}

}  // namespace axisc::grammar
