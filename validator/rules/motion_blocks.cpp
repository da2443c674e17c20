#include "validator/rules/motion_blocks.hpp"

#include "grammar/number.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace axisc::validator {
namespace {

using grammar::WordKind;

std::optional<int> function_number(std::string_view word) {
  int number = 0;
  if (word.size() < 2 || word.front() != 'G') return std::nullopt;
  char const* const end = word.data() + word.size();
  auto const [stop, error] = std::from_chars(word.data() + 1, end, number);
  return error == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

/// Letters that axes begin with, and those of a circle.
bool is_of_axis(char letter) {
  return std::string_view("XYZABCUVWQ").find(letter) != std::string_view::npos;
}
bool gives_destination(char letter) {
  return is_of_axis(letter) || std::string_view("IJKR").find(letter) != std::string_view::npos;
}

std::optional<double> number_of(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  return grammar::real_value(text);
}

std::optional<machine::Slope> slope_named(std::string_view word) {
  if (word == "STEP" || word == "0") return machine::Slope::step;
  if (word == "TRAPEZ" || word == "1") return machine::Slope::trapez;
  if (word == "SIN2" || word == "2") return machine::Slope::sin2;
  if (word == "HSC" || word == "3") return machine::Slope::hsc;
  return std::nullopt;
}

}  // namespace

std::string_view MotionBlock::text(std::size_t index) const {
  return text_.substr(words_[index].span.begin, words_[index].span.size());
}

std::string_view MotionBlock::next(std::size_t index) const {
  return index + 1 < words_.size() ? text(index + 1) : std::string_view();
}

std::vector<BlockFunction> MotionBlock::functions() const {
  std::vector<BlockFunction> found;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (words_[i].kind != WordKind::address && words_[i].kind != WordKind::name) continue;
    auto const number = function_number(text(i));
    if (!number) continue;
    BlockFunction function{.number = *number,
                           .word = schema::find_motion_word(*number),
                           .span = words_[i].span,
                           .index = i,
                           .value = std::nullopt,
                           .value_span = {}};
    if (next(i) == "=" && i + 2 < words_.size()) {
      function.value = number_of(text(i + 2));
      function.value_span = words_[i + 2].span;
    }
    found.push_back(function);
  }
  return found;
}

std::vector<BlockAxisWord> MotionBlock::axis_words_behind(std::size_t index) const {
  std::vector<BlockAxisWord> found;
  for (std::size_t i = index + 1; i < words_.size(); ++i) {
    std::string_view const word = text(i);
    if (!is_of_axis(word.front())) continue;
    if (words_[i].kind == WordKind::address) {
      found.push_back(
          {.axis = word.substr(0, 1), .span = words_[i].span, .value = number_of(word.substr(1))});
    } else if (words_[i].kind == WordKind::name && next(i) == "=" && i + 2 < words_.size()) {
      found.push_back({.axis = word, .span = words_[i].span, .value = number_of(text(i + 2))});
    }
  }
  return found;
}

bool MotionBlock::moves() const {
  bool gives = false;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    std::string_view const word = text(i);
    if (function_number(word) == 4) return false;
    bool const is_address = words_[i].kind == WordKind::address;
    bool const is_assigned = words_[i].kind == WordKind::name && (next(i) == "=" || next(i) == "[");
    // A call moves where the subprogram does.
    gives = gives || ((is_address || is_assigned) && gives_destination(word.front())) || word == "LL" ||
            word == "L";
  }
  return gives;
}

bool MotionBlock::names_slope() const {
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (text(i) == "#SLOPE" || (text(i) == "#SET" && next(i) == "SLOPE")) return true;
  }
  return false;
}

bool MotionBlock::weighs_all() const {
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (text(i) == "#SLOPE" && next(i) != "DEFAULT") return true;
  }
  return false;
}

bool MotionBlock::takes_default_slope() const {
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (text(i) == "#SLOPE" && next(i) == "DEFAULT") return true;
  }
  return false;
}

std::optional<machine::Slope> MotionBlock::slope(machine::Slope standard) const {
  if (!names_slope()) return std::nullopt;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (text(i) == "DEFAULT") return standard;
    if (words_[i].kind == WordKind::block_number) continue;
    if (auto const slope = slope_named(text(i))) return slope;
  }
  return std::nullopt;
}

bool programs_choose_slope(GroupContext const& context) {
  auto const chooses = [&](std::size_t index) {
    LoadedProgram const& program = context.whole.machine.programs[index];
    std::string_view const text = context.whole.sources[program.source].bytes();
    return std::any_of(
        program.tree.blocks.begin(), program.tree.blocks.end(),
        [text](grammar::WantedBlock const& block) { return MotionBlock(block, text).names_slope(); });
  };
  return std::any_of(context.group.programs.begin(), context.group.programs.end(), chooses);
}

}  // namespace axisc::validator
