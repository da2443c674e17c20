#include "analysis/motion/program/functions.hpp"

#include "analysis/motion/program/sentences.hpp"

#include <algorithm>

namespace axisc::motion::says {

constexpr Sentence cannot_simulate_offset{
    "`{word}` cannot be simulated: offsets are in lists that the simulation does not read",
    "`{word}` ist nicht simulierbar: Verschiebungen stehen in Listen, die die Simulation nicht liest"};
constexpr Sentence cannot_simulate_tool{
    "`{word}` cannot be simulated: the simulation knows no tools; it follows their centre (G40)",
    "`{word}` ist nicht simulierbar: die Simulation kennt keine Werkzeuge; sie folgt ihrer Mitte (G40)"};

}  // namespace axisc::motion::says

namespace axisc::motion {

FunctionMeaning take_function(int number, ModalWords& modal) {
  auto const plane = [&modal](char first, char second) {
    modal.plane_first = first;
    modal.plane_second = second;
  };
  switch (number) {
    case 0: modal.motion = MotionKind::rapid; return FunctionMeaning::nothing;
    case 1: modal.motion = MotionKind::line; return FunctionMeaning::nothing;
    case 2: modal.motion = MotionKind::clockwise; return FunctionMeaning::nothing;
    case 3: modal.motion = MotionKind::counterclockwise; return FunctionMeaning::nothing;
    case 4: return FunctionMeaning::dwell;
    case 17: plane('X', 'Y'); return FunctionMeaning::nothing;
    case 18: plane('Z', 'X'); return FunctionMeaning::nothing;
    case 19: plane('Y', 'Z'); return FunctionMeaning::nothing;
    case 40:
    case 53:
    case 80:
    case 162: return FunctionMeaning::nothing;  // the functions that they switch off are not supported
    case 41:
    case 42: return FunctionMeaning::needs_tools;
    case 54:
    case 55:
    case 56:
    case 57:
    case 58:
    case 59:
    case 92:
    case 159: return FunctionMeaning::needs_offsets;
    case 70:
    case 71: modal.inch = number == 70; return FunctionMeaning::nothing;
    case 90:
    case 91: modal.incremental = number == 91; return FunctionMeaning::nothing;
    case 94:
    case 95:
      // A feed rate has the unit that counted when it was written.
      if (modal.feed_per_revolution != (number == 95)) modal.feed.reset();
      modal.feed_per_revolution = number == 95;
      return FunctionMeaning::nothing;
    default: return FunctionMeaning::unknown;
  }
}

SentenceRef refusal_of(FunctionMeaning meaning) {
  switch (meaning) {
    case FunctionMeaning::needs_tools: return says::cannot_simulate_tool;
    case FunctionMeaning::needs_offsets: return says::cannot_simulate_offset;
    case FunctionMeaning::nothing:
    case FunctionMeaning::dwell:
    case FunctionMeaning::unknown: return says::cannot_simulate;
  }
  return says::cannot_simulate;
}

bool ChosenFunctions::choose(int number) {
  constexpr int none = -1;
  constexpr std::array<std::array<int, 4>, group_count> groups{{{0, 1, 2, 3},
                                                                {17, 18, 19, none},
                                                                {40, 41, 42, none},
                                                                {70, 71, none, none},
                                                                {90, 91, none, none},
                                                                {94, 95, none, none},
                                                                {8, 9, 193, 293},
                                                                {115, 116, 117, none}}};
  auto const* const group = std::find_if(groups.begin(), groups.end(), [number](auto const& numbers) {
    return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
  });
  if (group == groups.end()) return true;
  auto& chosen = chosen_.at(static_cast<std::size_t>(group - groups.begin()));
  if (chosen.value_or(number) != number) return false;
  chosen = number;
  return true;
}

}  // namespace axisc::motion
