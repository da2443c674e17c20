#include "analysis/motion/program/block_motion.hpp"

#include "analysis/motion/program/arc_words.hpp"
#include "analysis/motion/program/unused_words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <variant>

namespace axisc::motion::says {

constexpr Sentence cannot_simulate_too_far{
    "`{word}` lies beyond what the runtime can represent",
    "`{word}` liegt außerhalb dessen, was das Laufzeitsystem darstellen kann"};
constexpr Sentence cannot_simulate_feed{
    "a motion in G01 needs a feed rate: write F before or in this block",
    "eine Bewegung in G01 braucht einen Vorschub: F vor oder in diesem Satz schreiben"};
constexpr Sentence cannot_simulate_feed_range{"`{word}`: the feed rate must be above 0",
                                              "`{word}`: der Vorschub muss über 0 liegen"};
constexpr Sentence cannot_simulate_speed{
    "a feed rate per revolution (G95) needs a spindle speed: write S before or in this block",
    "ein Vorschub je Umdrehung (G95) braucht eine Drehzahl: S vor oder in diesem Satz schreiben"};
constexpr Sentence cannot_simulate_plane{"the channel has no axes for a circle in this plane",
                                         "der Kanal hat keine Achsen für einen Kreis in dieser Ebene"};
constexpr Sentence cannot_simulate_stop{
    "`{word}` stops at the end of the motion of its block, and this one has none (the control: 20003); "
    "`G360` stops at the end of every block",
    "`{word}` hält am Ende der Bewegung seines Satzes, und dieser hat keine (die Steuerung: 20003); `G360` "
    "hält am Ende jedes Satzes"};
constexpr Sentence cannot_simulate_no_arc{"`{word}` is only valid in blocks with G02 or G03",
                                          "`{word}` gilt nur in Sätzen mit G02 oder G03"};

}  // namespace axisc::motion::says

namespace axisc::motion {
namespace {

/// Beyond it positions are not exact any more, and the runtime refuses them: 2^53 units.
constexpr double furthest = 9007199254740992.0;

}  // namespace

BlockMotion::BlockMotion(NcBlock const& block, ProgramState& state) : block_(block), state_(state) {
  next_.line = block.tokens.front().line;
  next_.end = state.modal.position;
}

void BlockMotion::take_coordinate(Token const& token, std::size_t axis, double value) {
  auto const& modal = state_.modal;
  double const unit = state_.channel.rotary[axis] ? units_per_mm : modal.length_unit();
  double const target = (modal.incremental ? modal.position[axis] : 0) + value * unit;
  if (!(std::abs(target) <= furthest)) {
    return state_.problems.refuse(block_, token, says::cannot_simulate_too_far);
  }
  if (moved_.test(axis)) return state_.problems.refuse(block_, token, says::cannot_simulate_twice);
  moved_.set(axis);
  next_.end[axis] = target;
  if (!moves_) first_coordinate_ = token;
  moves_ = true;
}

void BlockMotion::take_arc_word(Token const& token, char letter, double value) {
  double const length = value * state_.modal.length_unit();
  if (!(std::abs(length) <= furthest)) {
    return state_.problems.refuse(block_, token, says::cannot_simulate_too_far);
  }
  auto& word = letter == 'R' ? radius_ : to_center_.at(static_cast<std::size_t>(letter - 'I'));
  if (word) return state_.problems.refuse(block_, token, says::cannot_simulate_twice);
  if (!asks_for_arc()) first_arc_word_ = token;
  if (!moves_) first_coordinate_ = token;
  moves_ = true;
  word = length;
}

void BlockMotion::take_feed(Token const& token, double value) {
  if (!(value > 0)) return state_.problems.refuse(block_, token, says::cannot_simulate_feed_range);
  if (std::exchange(feed_named_, true)) {
    return state_.problems.refuse(block_, token, says::cannot_simulate_twice);
  }
  state_.modal.feed = value * state_.modal.length_unit();
}

void BlockMotion::take_speed(Token const& token, double value) {
  if (std::exchange(speed_named_, true)) {
    return state_.problems.refuse(block_, token, says::cannot_simulate_twice);
  }
  state_.modal.speed = value;
  note_speed(block_, token, state_.problems);
}

void BlockMotion::move() {
  if (!moves_) return;
  moves_ = false;
  moved_.reset();
  next_.feed = feed();
  next_.dynamics = state_.modal.dynamics;
  next_.rapid = state_.modal.motion == MotionKind::rapid;
  next_.exact_stop =
      stop_ || state_.modal.stops || (next_.rapid && state_.channel.dynamics.stops_after_rapid);
  next_.brakes_late = state_.modal.brakes_late && !brakes_in_time_;
  if (rounds_corner_ || state_.modal.rounds_corners) {
    state_.rounding = std::max(state_.rounding.value_or(0), state_.modal.path_deviation);
  }
  has_moved_ = true;
  if (next_.label.empty()) next_.label = "L" + std::to_string(next_.line);
  bool const is_possible = make_arc();
  to_center_ = {};
  radius_.reset();
  if (!is_possible) return;
  state_.modal.position = next_.end;
  state_.listener.motion(next_);
}

void BlockMotion::finish() {
  if (stop_ && !has_moved_) state_.problems.refuse(block_, *stop_, says::cannot_simulate_stop);
}

/// Position units per cycle. A missing feed is refused once in a program.
double BlockMotion::feed() {
  auto& modal = state_.modal;
  if (modal.motion == MotionKind::rapid) return std::numeric_limits<double>::infinity();
  if (!modal.feed) {
    state_.problems.refuse(block_, first_coordinate_, says::cannot_simulate_feed);
    modal.feed = 1;
  }
  if (modal.feed_per_revolution && !(modal.speed.value_or(0) > 0)) {
    state_.problems.refuse(block_, first_coordinate_, says::cannot_simulate_speed);
    modal.speed = 1;
  }
  if (modal.feed_per_revolution) state_.problems.used();
  double const minutes = state_.channel.cycle_time.seconds() / 60;
  // Too small for a double is still a motion.
  double const feed = *modal.feed * (modal.feed_per_revolution ? *modal.speed : 1) * minutes;
  return std::max(feed, std::numeric_limits<double>::min());
}

bool BlockMotion::asks_for_arc() const {
  return radius_ ||
         std::any_of(to_center_.begin(), to_center_.end(), [](auto const& word) { return word.has_value(); });
}

/// False where the block describes no circle that can be followed.
bool BlockMotion::make_arc() {
  auto const& modal = state_.modal;
  next_.arc = nullptr;
  if (modal.motion != MotionKind::clockwise && modal.motion != MotionKind::counterclockwise) {
    bool const asks = asks_for_arc();
    if (asks) state_.problems.refuse(block_, first_arc_word_, says::cannot_simulate_no_arc);
    return !asks;
  }
  auto const first = state_.channel.axis_beginning_with(modal.plane_first);
  auto const second = state_.channel.axis_beginning_with(modal.plane_second);
  if (!first || !second) {
    state_.problems.refuse(block_, first_coordinate_, says::cannot_simulate_plane);
    return false;
  }
  ArcWords words;
  words.first = *first;
  words.second = *second;
  words.clockwise = modal.motion == MotionKind::clockwise;
  words.to_center_first = to_center_.at(static_cast<std::size_t>(modal.plane_first - 'X'));
  words.to_center_second = to_center_.at(static_cast<std::size_t>(modal.plane_second - 'X'));
  words.radius = radius_;
  auto found = arc_of(words, modal.position, next_.end);
  if (auto const* const mistake = std::get_if<ArcMistake>(&found)) {
    state_.problems.refuse(block_, first_coordinate_, sentence_of(*mistake));
    return false;
  }
  next_.arc = std::make_shared<Arc const>(std::get<Arc>(found));
  return true;
}

}  // namespace axisc::motion
