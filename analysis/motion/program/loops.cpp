#include "analysis/motion/program/loops.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace axisc::motion {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> loops = {
    {{"$FOR", "$ENDFOR"}, {"$WHILE", "$ENDWHILE"}, {"$REPEAT", "$UNTIL"}}};

}  // namespace

bool opens_loop(std::string_view control) {
  return std::any_of(loops.begin(), loops.end(),
                     [control](auto const& loop) { return loop.first == control; });
}

bool closes_loop(std::string_view control) {
  return std::any_of(loops.begin(), loops.end(),
                     [control](auto const& loop) { return loop.second == control; });
}

std::size_t loop_size(KeptBlocks blocks) {
  int depth = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    auto const block = blocks[i].block();
    auto const control = block.control();
    if (opens_loop(control)) ++depth;
    if (closes_loop(control)) --depth;
    if (depth <= 0) return i + 1;
  }
  return 0;
}

void LoopRounds::check() {
  std::pair const found{opening_.control(), closing_.control()};
  if (std::find(loops.begin(), loops.end(), found) == loops.end()) {
    problems_.refuse(opening_, opening_.tokens[opening_.first_word()], says::cannot_simulate_open);
  }
}

bool LoopRounds::begins() {
  auto const at = opening_.first_word();
  auto const control = opening_.control();
  if (control == "$REPEAT") return true;
  if (control == "$WHILE") return variables_.value_behind(at, opening_, problems_) != 0;
  return count(at);
}

/// $FOR P1 = first, last, step
bool LoopRounds::count(std::size_t at) {
  auto const tokens = opening_.tokens;
  Token const& word = tokens[at];
  bool const complete = at + 3 < tokens.size() && opening_.text(tokens[at + 2]) == "=";
  if (!complete) {
    problems_.refuse(opening_, word, says::cannot_simulate_here);
    return false;
  }
  std::string const name(opening_.text(tokens[at + 1]));
  std::uint32_t place = tokens[at + 3].span.begin;
  std::array<double, 3> numbers{0, 0, 1};
  std::size_t given = 0;
  while (given < numbers.size()) {
    auto const value = variables_.value_at(place, opening_, word, problems_);
    if (!value) return false;
    numbers.at(given++) = *value;
    if (!opening_.lines.substr(place - opening_.offset).starts_with(',')) break;
    ++place;
  }
  auto const [first, last, step] = numbers;
  if (!is_variable(name) || given < 2 || tokens.back().span.begin >= place || step == 0) {
    problems_.refuse(opening_, word, says::cannot_simulate_here);
    return false;
  }
  auto& variable = variables_[name];
  variable = std::exchange(is_first_, false) ? first : variable + step;
  return step > 0 ? variable <= last : variable >= last;
}

bool LoopRounds::goes_on() {
  bool const has_condition = closing_.control() == "$UNTIL";
  return !has_condition || variables_.value_behind(closing_.first_word(), closing_, problems_) == 0;
}

}  // namespace axisc::motion
