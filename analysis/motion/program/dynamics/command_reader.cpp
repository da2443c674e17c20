#include "analysis/motion/program/dynamics/command_reader.hpp"

#include <cstdint>

namespace axisc::motion {

std::string_view CommandReader::next() const {
  return at_end() ? std::string_view() : block_.text(block_.tokens[at_]);
}

std::string_view CommandReader::take() {
  std::string_view const word = next();
  if (!at_end()) ++at_;
  return word;
}

bool CommandReader::take(std::string_view word) {
  bool const is_next = !at_end() && next() == word;
  if (is_next) ++at_;
  return is_next;
}

std::optional<double> CommandReader::take_number() {
  Token const& name = block_.tokens[name_];
  if (at_end()) {
    state_.problems.refuse(block_, name, says::cannot_simulate_here);
    return std::nullopt;
  }
  std::uint32_t place = block_.tokens[at_].span.begin;
  auto const value = state_.variables.value_at(place, block_, name, state_.problems);
  while (value && !at_end() && block_.tokens[at_].span.begin < place) ++at_;
  return value;
}

void CommandReader::refuse(SentenceRef text) {
  state_.problems.refuse(block_, block_.tokens[name_], text);
}

}  // namespace axisc::motion
