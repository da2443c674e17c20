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

constexpr Sentence cannot_simulate_exact_stop{
    "`{word}` cannot be simulated: such a stop lasts until the position lag is small enough (P-AXIS-00236), "
    "and the lag is not simulated; `G04 F0` in a block of its own stops until the filters have settled",
    "`{word}` ist nicht simulierbar: ein solcher Halt dauert, bis der Schleppabstand klein genug ist "
    "(P-AXIS-00236), und der wird nicht simuliert; `G04 F0` in einem eigenen Satz hält, bis die Filter "
    "eingeschwungen sind"};
constexpr Sentence cannot_simulate_braking{
    "`{word}` cannot be simulated: on this control it is not an exact stop, but says where the path has "
    "slowed down to the next feed rate (with G901)",
    "`{word}` ist nicht simulierbar: auf dieser Steuerung ist es kein Genauhalt, sondern bestimmt, wo die "
    "Bahn auf den nächsten Vorschub gebremst hat (mit G901)"};
constexpr Sentence cannot_simulate_foreign{
    "`{word}` is not a word of this control; `G359` ends exact stops",
    "`{word}` ist kein Wort dieser Steuerung; Genauhalte beendet `G359`"};

}  // namespace axisc::motion::says

namespace axisc::motion {

FunctionMeaning take_function(int number, ModalWords& modal) {
  auto const plane = [&modal](char first, char second) {
    modal.plane_first = first;
    modal.plane_second = second;
  };
  switch (number) {
    case 0:
      modal.motion = MotionKind::rapid;
      return FunctionMeaning::nothing;
    case 1:
      modal.motion = MotionKind::line;
      return FunctionMeaning::nothing;
    case 2:
      modal.motion = MotionKind::clockwise;
      return FunctionMeaning::nothing;
    case 3:
      modal.motion = MotionKind::counterclockwise;
      return FunctionMeaning::nothing;
    case 4:
      return FunctionMeaning::dwell;
    case 8:
      return FunctionMeaning::ignored;
    case 9:
      return FunctionMeaning::braking;
    case 17:
      plane('X', 'Y');
      return FunctionMeaning::nothing;
    case 18:
      plane('Z', 'X');
      return FunctionMeaning::nothing;
    case 19:
      plane('Y', 'Z');
      return FunctionMeaning::nothing;
    case 40:
    case 53:
    case 80:
    case 162:
    case 260:
    case 359:
      return FunctionMeaning::nothing;  // the functions that they switch off are not supported
    case 41:
    case 42:
      return FunctionMeaning::needs_tools;
    case 54:
    case 55:
    case 56:
    case 57:
    case 58:
    case 59:
    case 92:
    case 159:
      return FunctionMeaning::needs_offsets;
    case 60:
    case 360:
      return FunctionMeaning::exact_stop;
    case 61:
    case 261:
      return FunctionMeaning::rounds_corners;
    case 64:
      return FunctionMeaning::foreign;
    case 70:
    case 71:
      modal.inch = number == 70;
      return FunctionMeaning::nothing;
    case 90:
    case 91:
      modal.incremental = number == 91;
      return FunctionMeaning::nothing;
    case 94:
    case 95:
      // A feed rate has the unit that counted when it was written.
      if (modal.feed_per_revolution != (number == 95)) modal.feed.reset();
      modal.feed_per_revolution = number == 95;
      return FunctionMeaning::nothing;
    default:
      return FunctionMeaning::unknown;
  }
}

SentenceRef refusal_of(FunctionMeaning meaning) {
  switch (meaning) {
    case FunctionMeaning::needs_tools:
      return says::cannot_simulate_tool;
    case FunctionMeaning::needs_offsets:
      return says::cannot_simulate_offset;
    case FunctionMeaning::exact_stop:
      return says::cannot_simulate_exact_stop;
    case FunctionMeaning::braking:
      return says::cannot_simulate_braking;
    case FunctionMeaning::rounds_corners:
      return says::cannot_simulate_rounding;
    case FunctionMeaning::foreign:
      return says::cannot_simulate_foreign;
    case FunctionMeaning::nothing:
    case FunctionMeaning::dwell:
    case FunctionMeaning::ignored:
    case FunctionMeaning::unknown:
      return says::cannot_simulate;
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
                                                                {94, 95, none, none}}};
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
