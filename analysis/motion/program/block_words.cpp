#include "analysis/motion/program/block_words.hpp"

#include "analysis/motion/program/block_commands.hpp"
#include "analysis/motion/program/dynamics/block_weights.hpp"
#include "analysis/motion/program/filter_change.hpp"
#include "analysis/motion/program/numbers.hpp"
#include "analysis/motion/program/unused_words.hpp"

#include <cmath>
#include <cstdint>
#include <string>

namespace axisc::motion::says {

constexpr Sentence cannot_simulate_both{"`{word}`: another word of this block excludes it",
                                        "`{word}`: ein anderes Wort dieses Satzes schließt es aus"};
constexpr Sentence cannot_simulate_number{"`{word}` needs a number", "`{word}` braucht eine Zahl"};
constexpr Sentence cannot_simulate_value{"`{word}` needs a value: `{word}=100`",
                                         "`{word}` braucht einen Wert: `{word}=100`"};
constexpr Sentence cannot_simulate_functions{
    "`{word}`: the functions of the look-ahead are a whole number from 0 to 14 (the control: 20151)",
    "`{word}`: die Funktionen der Vorausschau sind eine ganze Zahl von 0 bis 14 (die Steuerung: 20151)"};
constexpr Sentence cannot_simulate_weight{
    "`{word}`: a weight is in percent, above 0 for an acceleration and at least 0 for the rest",
    "`{word}`: ein Gewicht steht in Prozent, über 0 für eine Beschleunigung und sonst mindestens 0"};
constexpr Sentence cannot_simulate_file{
    "`{word}`: subprograms in other files are not read; put it before the program with %L, and call it "
    "with LL",
    "`{word}`: Unterprogramme in anderen Dateien werden nicht gelesen; mit %L vor das Programm schreiben "
    "und mit LL rufen"};

}  // namespace axisc::motion::says

namespace axisc::motion {

using schema::find_motion_word;
using schema::MotionEffect;
using schema::MotionWord;
using schema::Weighting;
using schema::WordUse;

namespace {

using grammar::WordKind;

/// The sum of all that G115 chooses from.
constexpr unsigned all_functions = 14;

bool is_one_of(std::string_view letters, std::string_view name) {
  return name.size() == 1 && letters.find(name) != std::string_view::npos;
}

}  // namespace

BlockOutcome BlockWords::execute() {
  state_.problems.begin_block();
  for (std::size_t at = 0; at < block_.tokens.size() && !state_.ended && !state_.problems.refused();) {
    at = take(at);
  }
  if (state_.ended || state_.problems.refused()) return outcome_;
  motion_.move();
  if (!state_.problems.refused()) motion_.finish();
  if (!state_.problems.refused()) dwell_.finish();
  return outcome_;
}

/// Understands what begins with the token and returns the place after it.
std::size_t BlockWords::take(std::size_t at) {
  Token const& token = block_.tokens[at];
  if (token.command) return take_command(at);
  switch (token.kind) {
    case WordKind::skip:
    case WordKind::program: return at + 1;
    case WordKind::block_number: motion_.set_label(block_.text(token)); return at + 1;
    case WordKind::address: return take_address(at);
    case WordKind::name: return take_assignment(at);
    case WordKind::number:
      if (dwell_.is_open() && !dwell_.has_time()) {
        dwell_.take(token, real_number(block_.text(token)).value_or(-1));
      } else {
        refuse(token);
      }
      return at + 1;
    default: refuse(token); return at + 1;
  }
}

std::size_t BlockWords::take_address(std::size_t at) {
  Token const& token = block_.tokens[at];
  std::string_view const word = block_.text(token);
  std::string_view const number = word.substr(1);
  switch (word.front()) {
    case 'P': return take_assignment(at);  // P1 = 5, with blanks
    case 'N': motion_.set_label(word); break;
    case 'G': return take_g(at, number);
    case 'M': take_m(token, number); break;
    default:
      if (auto const value = real_number(number)) {
        take_value(token, word.substr(0, 1), *value);
      } else {
        refuse(token, says::cannot_simulate_number);
      }
  }
  return at + 1;
}

/// X=5, X1=P1, P1=2*P2, X[P1+1], and calls of subprograms.
std::size_t BlockWords::take_assignment(std::size_t at) {
  auto const tokens = block_.tokens;
  Token const& token = tokens[at];
  std::string const name(block_.text(token));
  if (name == "LL" || name == "L") return take_call(at);
  if (name.size() > 1 && name.front() == 'G' && whole_number(std::string_view(name).substr(1))) {
    return take_g(at, std::string_view(name).substr(1));
  }
  std::string_view const behind = at + 1 < tokens.size() ? block_.text(tokens[at + 1]) : std::string_view();
  bool const is_word = state_.channel.axis(name) || is_one_of("FIJKRS", name);
  bool const is_assignment = behind == "=" && at + 2 < tokens.size();
  if (!(is_assignment && (is_word || is_variable(name))) && !(behind == "[" && is_word)) {
    refuse(token);
    return tokens.size();
  }
  std::uint32_t place = tokens[is_assignment ? at + 2 : at + 1].span.begin;
  auto const value = state_.variables.value_at(place, block_, token, state_.problems);
  if (!value) return tokens.size();
  if (is_variable(name)) {
    state_.variables[name] = *value;
  } else {
    take_value(token, name, *value);
  }
  while (at < tokens.size() && tokens[at].span.begin < place) ++at;
  return at;
}

std::size_t BlockWords::take_call(std::size_t at) {
  Token const& token = block_.tokens[at];
  if (block_.text(token) == "L") {
    refuse(token, says::cannot_simulate_file);
  } else if (dwell_.is_open() || outcome_.returns) {
    refuse(token, says::cannot_simulate_here);
  } else {
    motion_.move();
    if (!state_.problems.refused()) outcome_.call = at;
  }
  return block_.tokens.size();
}

std::size_t BlockWords::take_command(std::size_t at) {
  Token const& token = block_.tokens[at];
  auto const kind = block_.commands[*token.command].kind;
  if (kind == grammar::CommandKind::filter || kind == grammar::CommandKind::vibration_guard) {
    motion_.move();
    auto const change = read_filter_change(block_, token, state_.channel, state_.problems);
    if (change) state_.listener.command(*change);
    return at + 1;
  }
  take_other_command(at, block_, state_);
  return block_.tokens.size();
}

std::size_t BlockWords::take_g(std::size_t at, std::string_view digits) {
  Token const& token = block_.tokens[at];
  auto const number = whole_number(digits);
  if (!number) return refuse(token), at + 1;
  if (!chosen_.choose(*number)) return refuse(token, says::cannot_simulate_both), at + 1;
  if (auto const* const word = find_motion_word(*number)) return take_motion_word(*word, at);
  auto const meaning = take_function(*number, state_.modal);
  switch (meaning) {
    case FunctionMeaning::nothing: break;
    case FunctionMeaning::dwell:
      motion_.moves() ? refuse(token, says::cannot_simulate_beside_dwell) : dwell_.begin(token);
      break;
    case FunctionMeaning::needs_tools:
    case FunctionMeaning::needs_offsets:
    case FunctionMeaning::unknown: refuse(token, refusal_of(meaning)); break;
  }
  return at + 1;
}

std::size_t BlockWords::take_motion_word(MotionWord const& word, std::size_t at) {
  Token const& token = block_.tokens[at];
  bool const rounds = word.effect == MotionEffect::round_corner || word.effect == MotionEffect::round_corners;
  if (word.use == WordUse::refused && !(rounds && state_.channel.sharp_corners)) {
    refuse(token, *word.refusal);
    return at + 1;
  }
  auto& modal = state_.modal;
  switch (word.effect) {
    case MotionEffect::stop: motion_.stop_at_end(token); break;
    case MotionEffect::stop_from_here:
    case MotionEffect::stop_no_more: modal.stops = word.effect == MotionEffect::stop_from_here; break;
    case MotionEffect::brake_late:
    case MotionEffect::brake_in_time: modal.brakes_late = word.effect == MotionEffect::brake_late; break;
    case MotionEffect::brake_in_time_here: motion_.brake_in_time(); break;
    case MotionEffect::round_corner: motion_.round_corner(); break;
    case MotionEffect::round_corners:
    case MotionEffect::round_no_more:
      modal.rounds_corners = word.effect == MotionEffect::round_corners;
      break;
    case MotionEffect::limit_by:
    case MotionEffect::weigh:
      if (word.weighting.by_axis) {
        weighting_ = word.weighting;
        break;
      }
      return take_value_of(word, at);
    case MotionEffect::limit_by_all: set_look_ahead(all_functions); break;
    case MotionEffect::feed_forward:
    case MotionEffect::feed_no_more:
      state_.listener.feedforward(word.effect == MotionEffect::feed_forward, token.line);
      break;
    case MotionEffect::nothing:
    case MotionEffect::set_rounding:
    case MotionEffect::slope:
    case MotionEffect::slope_number:
    case MotionEffect::vector_limit:
    case MotionEffect::least_corner_velocity: break;
  }
  return at + 1;
}

/// G131=50, G115=10.
std::size_t BlockWords::take_value_of(MotionWord const& word, std::size_t at) {
  Token const& token = block_.tokens[at];
  bool const is_assignment = at + 2 < block_.tokens.size() && block_.text(block_.tokens[at + 1]) == "=";
  if (!is_assignment) return refuse(token, says::cannot_simulate_value), block_.tokens.size();
  std::uint32_t place = block_.tokens[at + 2].span.begin;
  auto const value = state_.variables.value_at(place, block_, token, state_.problems);
  if (!value) return block_.tokens.size();
  if (word.effect == MotionEffect::limit_by) {
    bool const is_sum = *value >= 0 && *value <= all_functions && *value == std::floor(*value);
    if (!is_sum) return refuse(token, says::cannot_simulate_functions), block_.tokens.size();
    set_look_ahead(static_cast<unsigned>(*value));
  } else {
    for (std::size_t axis = 0; axis < state_.channel.axes.size(); ++axis) {
      weigh(token, word.weighting, axis, *value);
    }
  }
  while (at < block_.tokens.size() && block_.tokens[at].span.begin < place) ++at;
  return at;
}

void BlockWords::weigh(Token const& token, Weighting const& weighting, std::size_t axis, double percent) {
  if (state_.problems.refused()) return;
  bool const may_be_zero = weighting.of != Weighting::Of::acceleration;
  if (!(percent > 0 || (may_be_zero && percent == 0))) return refuse(token, says::cannot_simulate_weight);
  if (weighting.in == Weighting::In::no_plan) return;
  change_dynamics(state_.modal, state_.channel.dynamics, [&](BlockDynamics& dynamics) {
    weigh_axis(dynamics, state_.modal, weighting, axis, percent);
  });
}

void BlockWords::set_look_ahead(unsigned functions) {
  constexpr unsigned corners = 2;
  constexpr unsigned curves = 8;
  change_dynamics(state_.modal, state_.channel.dynamics, [functions](BlockDynamics& dynamics) {
    dynamics.limits_corners = (functions & corners) != 0;
    dynamics.limits_curves = (functions & curves) != 0;
  });
}

void BlockWords::take_m(Token const& token, std::string_view digits) {
  auto const number = whole_number(digits);
  if (!number) return refuse(token);
  bool const returns = *number == 17 || *number == 29;
  bool const ends = *number == 2 || *number == 30 || (returns && !in_subprogram_);
  if (!returns && !ends) return ignore_technology(block_, token, state_.problems);
  motion_.move();
  if (ends) {
    state_.end();
  } else {
    outcome_.returns = true;
  }
}

/// F, S, I, J, K, R or an axis with its number.
void BlockWords::take_value(Token const& token, std::string_view name, double value) {
  auto const axis = state_.channel.axis(name);
  if (dwell_.is_open() && (axis || name.front() == 'F')) return dwell_.take(token, value);
  if (axis && weighting_) return weigh(token, *weighting_, *axis, value);
  if (axis) return motion_.take_coordinate(token, *axis, value);
  if (is_one_of("F", name)) return motion_.take_feed(token, value);
  if (is_one_of("IJKR", name)) return motion_.take_arc_word(token, name.front(), value);
  if (is_one_of("S", name)) return motion_.take_speed(token, value);
  take_unused_value(block_, token, name, state_.problems);
}

void BlockWords::refuse(Token const& token, SentenceRef text) {
  state_.problems.refuse(block_, token, text);
}

}  // namespace axisc::motion
