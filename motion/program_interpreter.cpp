#include "motion/program_interpreter.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace axisc::motion::says {

constexpr Sentence not_simulated{"the simulation ignores `{word}`", "die Simulation übergeht `{word}`"};
constexpr Sentence not_simulated_axis{"the simulation ignores `{word}`: the channel has no axis {axis}",
                                      "die Simulation übergeht `{word}`: der Kanal hat keine Achse {axis}"};
constexpr Sentence not_simulated_technology{
    "the simulation ignores spindle, tool and M words, such as `{word}`",
    "die Simulation übergeht Spindel-, Werkzeug- und M-Wörter wie `{word}`"};
constexpr Sentence cannot_simulate_slope{
    "`{word}`: the simulation plans with TYPE=STEP, TYPE=TRAPEZ or TYPE=SIN2 alone",
    "`{word}`: die Simulation plant nur mit TYPE=STEP, TYPE=TRAPEZ oder TYPE=SIN2"};
constexpr Sentence cannot_simulate_offset{
    "`{word}` cannot be simulated: offsets are in lists that the simulation does not read",
    "`{word}` ist nicht simulierbar: Verschiebungen stehen in Listen, die die Simulation nicht liest"};
constexpr Sentence cannot_simulate_tool{
    "`{word}` cannot be simulated: the simulation knows no tools; it follows their centre (G40)",
    "`{word}` ist nicht simulierbar: die Simulation kennt keine Werkzeuge; sie folgt ihrer Mitte (G40)"};
constexpr Sentence cannot_simulate_dwell{
    "G04 needs a time in seconds, up to a day: `G04 X1.5`",
    "G04 braucht eine Zeit in Sekunden, höchstens einen Tag: `G04 X1.5`"};
constexpr Sentence cannot_simulate_beside_dwell{
    "`{word}` cannot be simulated here: a dwell (G04) needs a block of its own",
    "`{word}` ist hier nicht simulierbar: eine Verweilzeit (G04) braucht einen eigenen Satz"};
constexpr Sentence cannot_simulate_twice{"`{word}`: this block has a value for it already",
                                         "`{word}`: dieser Satz hat schon einen Wert dafür"};
constexpr Sentence cannot_simulate_both{"`{word}`: another word of this block excludes it",
                                        "`{word}`: ein anderes Wort dieses Satzes schließt es aus"};
constexpr Sentence cannot_simulate_speed{
    "a feed rate per revolution (G95) needs a spindle speed: write S before or in this block",
    "ein Vorschub je Umdrehung (G95) braucht eine Drehzahl: S vor oder in diesem Satz schreiben"};
constexpr Sentence cannot_simulate_plane{"the channel has no axes for a circle in this plane",
                                         "der Kanal hat keine Achsen für einen Kreis in dieser Ebene"};
constexpr Sentence cannot_simulate_no_arc{"`{word}` is only valid in blocks with G02 or G03",
                                          "`{word}` gilt nur in Sätzen mit G02 oder G03"};
constexpr Sentence arc_no_center{"a circle needs its centre (I, J, K) or its radius (R)",
                                 "ein Kreis braucht seinen Mittelpunkt (I, J, K) oder seinen Radius (R)"};
constexpr Sentence arc_both{"a circle has either a centre (I, J, K) or a radius (R)",
                            "ein Kreis hat entweder einen Mittelpunkt (I, J, K) oder einen Radius (R)"};
constexpr Sentence arc_no_radius{"the centre of this circle is where it begins",
                                 "der Mittelpunkt dieses Kreises ist sein Anfang"};
constexpr Sentence arc_too_small{"the radius is too small: the circle does not reach its end",
                                 "der Radius ist zu klein: der Kreis erreicht sein Ende nicht"};
constexpr Sentence arc_full_by_radius{
    "a full circle needs its centre (I, J, K): R does not say where it lies",
    "ein Vollkreis braucht seinen Mittelpunkt (I, J, K): R sagt nicht, wo er liegt"};
constexpr Sentence arc_misses_end{
    "the end of this circle is more than 5 µm off: beginning and end have different radii",
    "das Ende dieses Kreises liegt mehr als 5 µm daneben: Anfang und Ende haben verschiedene Radien"};

constexpr Sentence cannot_simulate_number{"`{word}` needs a number", "`{word}` braucht eine Zahl"};
constexpr Sentence cannot_simulate_feed{
    "a motion in G01 needs a feed rate: write F before or in this block",
    "eine Bewegung in G01 braucht einen Vorschub: F vor oder in diesem Satz schreiben"};
constexpr Sentence cannot_simulate_feed_range{"`{word}`: the feed rate must be above 0",
                                              "`{word}`: der Vorschub muss über 0 liegen"};
constexpr Sentence cannot_simulate_too_far{
    "`{word}` lies beyond what the runtime can represent",
    "`{word}` liegt außerhalb dessen, was das Laufzeitsystem darstellen kann"};

}  // namespace axisc::motion::says

namespace axisc::motion {
namespace {

using grammar::WordKind;

constexpr Code not_simulated{9007};
constexpr Code cannot_simulate{9008};
constexpr double mm_per_inch = 25.4;
/// More than any block of a program: the reader ends blocks at 1 MiB.
constexpr std::size_t kept_at_most = std::size_t{4} << 20U;
constexpr std::size_t kept_at_least = std::size_t{2} << 20U;
/// Beyond it positions are not exact any more, and the runtime refuses them: 2^53 units.
constexpr double furthest = 9007199254740992.0;

/// Functions that leave path and filters as they are and are ignored with a warning.
constexpr std::array<int, 2> harmless = {8, 61};
/// Most that a G04 may ask for, in seconds.
constexpr double longest_dwell = 86400;

/// The beginnings of commands that change where the path lies or how it is planned.
constexpr std::array<std::string_view, 21> geometric_commands = {
    "#ACS",   "#AKIMA", "#BCS",      "#CS",     "#ECS",    "#HSC",    "#KIN",
    "#MCS",   "#PTP",   "#ROTATION", "#RTCP",   "#SCALE",  "#SPLINE", "#TLC",
    "#TRAFO", "#CYL",   "#FACE",     "#MIRROR", "#GANTRY", "#DIST",   "#TURN"};

SentenceRef sentence_of(ArcMistake mistake) {
  switch (mistake) {
    case ArcMistake::no_center:
      return says::arc_no_center;
    case ArcMistake::both:
      return says::arc_both;
    case ArcMistake::no_radius:
      return says::arc_no_radius;
    case ArcMistake::too_small:
      return says::arc_too_small;
    case ArcMistake::full_by_radius:
      return says::arc_full_by_radius;
    case ArcMistake::misses_end:
      return says::arc_misses_end;
  }
  return says::arc_no_center;
}

/// G words of one group count one after the other, so that a block has one of them. Their number where there is none.
std::size_t group_of(int number) {
  constexpr std::array<std::array<int, 4>, 7> groups{{{0, 1, 2, 3},
                                                      {17, 18, 19, -1},
                                                      {40, 41, 42, -1},
                                                      {60, 64, 360, -1},
                                                      {70, 71, -1, -1},
                                                      {90, 91, -1, -1},
                                                      {94, 95, -1, -1}}};
  auto const* const found = std::find_if(groups.begin(), groups.end(), [number](auto const& group) {
    return std::find(group.begin(), group.end(), number) != group.end();
  });
  return static_cast<std::size_t>(found - groups.begin());
}

std::optional<int> whole_number(std::string_view digits) {
  int value = 0;
  auto const* const end = digits.data() + digits.size();
  auto const [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<double> real_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  auto const* const end = text.data() + text.size();
  auto const [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_geometry_letter(char letter) {
  return std::string_view("ABCUVWXYZ").find(letter) != std::string_view::npos;
}

bool is_technology_letter(char letter) {
  return std::string_view("DHST").find(letter) != std::string_view::npos;
}

/// Spans of a command count from the start of the program; from here on they count from `base`.
void shift(grammar::NcCommand& command, std::uint32_t base) {
  auto const move = [base](Span& span) {
    span.begin -= std::min(base, span.begin);
    span.end -= std::min(base, span.end);
  };
  move(command.name);
  for (auto& keyword : command.keywords) {
    move(keyword.name);
    move(keyword.value);
  }
  if (command.problem) move(command.problem->span);
}

}  // namespace

ProgramInterpreter::ProgramInterpreter(ProgramChannel channel, PathListener& listener,
                                       std::function<void(ProgramProblem)> problem)
    : channel_(std::move(channel)),
      listener_(listener),
      problem_(std::move(problem)),
      reader_(*this, grammar::ProgramDetail::words),
      inch_(channel_.inch) {}

bool ProgramInterpreter::line(std::string_view text, std::uint32_t offset) {
  if (ended_) return false;
  keep(text, offset);
  reader_.line(text, offset);
  next_block();
  return !ended_;
}

void ProgramInterpreter::finish() {
  if (ended_) return;
  reader_.finish();
  next_block();
  refuse_open_blocks();
  if (!ended_) end();
}

/// Offsets stay those of the program: between two lines stand as many bytes as there.
void ProgramInterpreter::keep(std::string_view text, std::uint32_t offset) {
  if (kept_.size() > kept_at_most) {
    std::size_t const dropped = kept_.size() - kept_at_least;
    kept_.erase(0, dropped);
    kept_offset_ += static_cast<std::uint32_t>(dropped);
  }
  if (kept_.empty()) {
    kept_offset_ = offset;
  } else {
    kept_.resize(offset - kept_offset_, '\n');
  }
  kept_ += text;
}

std::string_view ProgramInterpreter::text(Span span) const {
  if (span.begin < kept_offset_) return {};
  return std::string_view(kept_).substr(span.begin - kept_offset_, span.size());
}

void ProgramInterpreter::word(grammar::Word const& word) {
  tokens_.push_back({.kind = word.kind, .span = word.span, .line = word.line, .command = std::nullopt});
}

void ProgramInterpreter::command(grammar::NcCommand command) {
  tokens_.push_back(
      {.kind = WordKind::other, .span = command.name, .line = command.line, .command = commands_.size()});
  commands_.push_back(std::move(command));
}

void ProgramInterpreter::block() {
  if (tokens_.empty()) return;
  next_.label.clear();
  next_.line = tokens_.front().line;
  next_.end = position_;
  moves_ = false;
  moved_.reset();
  chosen_ = {};
  dwells_ = false;
  refused_ = false;
  exact_stop_once_ = false;
  dwell_.reset();
  to_center_ = {};
  radius_.reset();
  for (std::size_t at = 0; at < tokens_.size() && !ended_ && !refused_;) at = take(at);
  if (!refused_ && !ended_) move();
  if (!refused_ && !ended_ && dwells_) {
    if (dwell_) {
      listener_.stop(*dwell_);
    } else {
      refuse(first_dwell_, says::cannot_simulate_dwell);
    }
  }
  tokens_.clear();
  commands_.clear();
}

/// Understands what begins with the token and returns the place behind it.
std::size_t ProgramInterpreter::take(std::size_t at) {
  Token const& token = tokens_[at];
  if (token.command) return take_command(at);
  switch (token.kind) {
    case WordKind::skip:
      return at + 1;
    case WordKind::block_number:
      next_.label = text(token.span);
      return at + 1;
    case WordKind::program:
      return at + 1;
    case WordKind::address:
      return take_address(at);
    case WordKind::name:
      return take_assignment(at);
    case WordKind::number:
      if (dwells_ && !dwell_) {
        take_dwell(token, real_number(text(token.span)).value_or(-1));
        return at + 1;
      }
      refuse(token);
      return tokens_.size();
    default:
      refuse(token);
      return tokens_.size();
  }
}

std::size_t ProgramInterpreter::take_address(std::size_t at) {
  Token const& token = tokens_[at];
  std::string_view const word = text(token.span);
  char const letter = word.front();
  std::string_view const number = word.substr(1);
  if (letter == 'P') return take_assignment(at);  // P1 = 5, with blanks
  if (letter == 'N') {
    next_.label = word;
  } else if (letter == 'G' || letter == 'M') {
    take_function(token, number);
  } else if (auto const value = real_number(number)) {
    take_value(token, word.substr(0, 1), *value);
  } else {
    refuse(token, says::cannot_simulate_number);
  }
  return at + 1;
}

/// X=5, X1=P1, P1=2*P2, X[P1+1], and calls of subprograms.
std::size_t ProgramInterpreter::take_assignment(std::size_t at) {
  Token const& token = tokens_[at];
  std::string const name(text(token.span));
  if (name == "LL" || name == "L") {
    call(at);
    return tokens_.size();
  }
  std::string_view const behind = at + 1 < tokens_.size() ? text(tokens_[at + 1].span) : std::string_view();
  bool const is_word =
      axis(name) || (name.size() == 1 && std::string_view("FIJKRS").find(name) != std::string_view::npos);
  bool const is_variable =
      name.starts_with("V.P.") || (name.size() > 1 && name.front() == 'P' && whole_number(name.substr(1)));
  bool const is_assignment = behind == "=" && at + 2 < tokens_.size();
  if (!(is_assignment && (is_word || is_variable)) && !(behind == "[" && is_word)) {
    refuse(token);
    return tokens_.size();
  }
  std::uint32_t place = is_assignment ? tokens_[at + 2].span.begin : tokens_[at + 1].span.begin;
  auto const value = evaluate(token, place);
  if (!value) return tokens_.size();
  if (is_variable) {
    variables_[name] = *value;
  } else {
    take_value(token, name, *value);
  }
  while (at < tokens_.size() && tokens_[at].span.begin < place) ++at;
  return at;
}

void ProgramInterpreter::take_value(Token const& token, std::string_view name, double value) {
  char const letter = name.front();
  auto const index = axis(name);
  if (dwells_ && (index || letter == 'F')) {
    if (dwell_) return refuse(token, says::cannot_simulate_beside_dwell);
    return take_dwell(token, value);
  }
  if (index) return take_coordinate(token, *index, value);
  double const length = value * units_per_mm * (inch_ ? mm_per_inch : 1);
  switch (letter) {
    case 'F':
      return take_feed(token, value);
    case 'I':
    case 'J':
    case 'K':
    case 'R':
      if (!(std::abs(length) <= furthest)) return refuse(token, says::cannot_simulate_too_far);
      return take_arc_word(
          token, letter == 'R' ? radius_ : to_center_.at(static_cast<std::size_t>(letter - 'I')), length);
    case 'S':
      speed_ = value;
      break;
    default:
      break;
  }
  if (is_geometry_letter(letter)) {
    ignore(token, std::string(1, letter), says::not_simulated_axis, {{"axis", std::string(1, letter)}});
  } else if (is_technology_letter(letter)) {
    ignore(token, "technology", says::not_simulated_technology);
  } else {
    refuse(token);
  }
}

void ProgramInterpreter::take_arc_word(Token const& token, std::optional<double>& word, double length) {
  if (word) return refuse(token, says::cannot_simulate_twice);
  bool const is_first = !radius_ && std::none_of(to_center_.begin(), to_center_.end(),
                                                 [](auto const& other) { return other.has_value(); });
  if (is_first) first_arc_word_ = token;
  if (!moves_) first_coordinate_ = token;
  moves_ = true;
  word = length;
}

void ProgramInterpreter::take_feed(Token const& token, double value) {
  if (!(value > 0)) return refuse(token, says::cannot_simulate_feed_range);
  feed_ = value * units_per_mm * (inch_ ? mm_per_inch : 1);
}

void ProgramInterpreter::take_dwell(Token const& token, double seconds) {
  if (!(seconds >= 0 && seconds <= longest_dwell)) return refuse(token, says::cannot_simulate_dwell);
  dwell_ = seconds / channel_.cycle_time.seconds();
}

void ProgramInterpreter::take_function(Token const& token, std::string_view digits) {
  bool const is_g = text(token.span).front() == 'G';
  auto const number = whole_number(digits);
  if (!number) return refuse(token);
  if (!is_g) {
    bool const returns = *number == 17 || *number == 29;
    if (*number == 30 || *number == 2 || (returns && calls_ == 0)) {
      move();
      return end();
    }
    if (returns) {
      move();
      leaves_ = Leaves::subprogram;
      return;
    }
    return ignore(token, "technology", says::not_simulated_technology);
  }
  if (auto const group = group_of(*number); group < chosen_.size()) {
    if (chosen_[group].value_or(*number) != *number) return refuse(token, says::cannot_simulate_both);
    chosen_[group] = *number;
  }
  auto const plane = [this](char first, char second) {
    plane_first_ = first;
    plane_second_ = second;
  };
  switch (*number) {
    case 0:
      motion_ = Motion::rapid;
      return;
    case 1:
      motion_ = Motion::line;
      return;
    case 2:
      motion_ = Motion::clockwise;
      return;
    case 3:
      motion_ = Motion::counterclockwise;
      return;
    case 4:
      dwells_ = true;
      first_dwell_ = token;
      return;
    case 9:
      exact_stop_once_ = true;
      return;
    case 17:
      return plane('X', 'Y');
    case 18:
      return plane('Z', 'X');
    case 19:
      return plane('Y', 'Z');
    case 40:
    case 53:
    case 80:
    case 162:
      return;  // what they switch off is not supported
    case 60:
      exact_stop_ = true;
      return;
    case 64:
    case 360:
      exact_stop_ = false;
      return;
    case 70:
    case 71:
      inch_ = *number == 70;
      return;
    case 90:
    case 91:
      incremental_ = *number == 91;
      return;
    case 94:
    case 95:
      // A feed rate has the unit that counted when it was written.
      if (feed_per_revolution_ != (*number == 95)) feed_.reset();
      feed_per_revolution_ = *number == 95;
      return;
    case 41:
    case 42:
      return refuse(token, says::cannot_simulate_tool);
    default:
      break;
  }
  bool const is_offset = (*number >= 54 && *number <= 59) || *number == 92 || *number == 159;
  if (is_offset) return refuse(token, says::cannot_simulate_offset);
  if (std::find(harmless.begin(), harmless.end(), *number) == harmless.end()) return refuse(token);
  ignore(token, "G" + std::to_string(*number), says::not_simulated);
}

void ProgramInterpreter::take_coordinate(Token const& token, std::size_t axis, double value) {
  double const unit = units_per_mm * (inch_ && !channel_.rotary[axis] ? mm_per_inch : 1);
  double const target = (incremental_ ? position_[axis] : 0) + value * unit;
  if (!(std::abs(target) <= furthest)) return refuse(token, says::cannot_simulate_too_far);
  if (moved_.test(axis)) return refuse(token, says::cannot_simulate_twice);
  moved_.set(axis);
  next_.end[axis] = target;
  if (!moves_) first_coordinate_ = token;
  moves_ = true;
}

std::size_t ProgramInterpreter::take_command(std::size_t at) {
  Token const& token = tokens_[at];
  auto const kind = commands_[*token.command].kind;
  if (kind == grammar::CommandKind::filter) {
    move();
    take_filter(token);
    return at + 1;
  }
  if (kind == grammar::CommandKind::vibration_guard || kind == grammar::CommandKind::axis_exchange) {
    refuse(token);
    return tokens_.size();
  }
  // Of other commands only the name was read: the rest of the block belongs to them.
  std::string written(text(token.span));
  for (std::size_t i = at + 1; i < tokens_.size(); ++i) written += text(tokens_[i].span);
  if (written.starts_with("#SLOPE")) {
    take_slope(token, written);
    return tokens_.size();
  }
  bool const is_geometric = std::any_of(geometric_commands.begin(), geometric_commands.end(),
                                        [&](std::string_view name) { return written.starts_with(name); });
  if (is_geometric) {
    refuse(token);
  } else {
    ignore(token, written, says::not_simulated);
  }
  return tokens_.size();
}

void ProgramInterpreter::take_slope(Token const& token, std::string_view written) {
  if (written == "#SLOPE[TYPE=TRAPEZ]" || written == "#SLOPE[TYPE=STEP]") {
    next_.slope = Slope::trapezoid;
  } else if (written == "#SLOPE[TYPE=SIN2]") {
    next_.slope = Slope::sine_squared;
  } else {
    refuse(token, says::cannot_simulate_slope);
  }
}

void ProgramInterpreter::take_filter(Token const& token) {
  grammar::NcCommand command = commands_[*token.command];
  shift(command, kept_offset_);
  FilterCommandReading const checked = channel_.read_filter_command(command, kept_);
  if (!checked.command || !checked.mistakes.empty()) {
    for (auto const& mistake : checked.mistakes) {
      Token const place{
          .kind = WordKind::other,
          .span = {.begin = mistake.span.begin + kept_offset_, .end = mistake.span.end + kept_offset_},
          .line = token.line,
          .command = {}};
      report(place, mistake.code, mistake.message.sentence, mistake.message.arguments);
    }
    if (checked.mistakes.empty()) refuse(token);
    return;
  }
  std::uint32_t last = command.name.end;
  for (auto const& keyword : command.keywords) {
    last = std::max({last, keyword.name.end, keyword.value.end});
  }
  FilterChange change;
  change.command = *checked.command;
  if (change.command.tolerance) {
    change.tolerance = *change.command.tolerance * units_per_mm * (channel_.inch ? mm_per_inch : 1);
  }
  auto const behind = kept_.find(']', last);
  auto const line_end = kept_.find('\n', last);
  bool const bracket = !command.keywords.empty() && behind != std::string::npos && behind < line_end;
  if (command.keywords.empty()) {
    char const* const word = change.command.filter_switch == machine::FilterSwitch::on ? " ON" : " OFF";
    bool const none = change.command.filter_switch == machine::FilterSwitch::unchanged;
    change.text = "#FILTER" + std::string(none ? "" : word);
  } else {
    change.text = kept_.substr(command.name.begin, (bracket ? behind + 1 : last) - command.name.begin);
  }
  change.line = token.line;
  listener_.command(change);
}

void ProgramInterpreter::move() {
  if (!moves_) {
    if (exact_stop_once_) listener_.stop(0);
    exact_stop_once_ = false;
    return;
  }
  moves_ = false;
  moved_.reset();
  bool const rapid = motion_ == Motion::rapid;
  if (!rapid && !feed_) {
    refuse(first_coordinate_, says::cannot_simulate_feed);
    feed_ = 1;  // said once
  }
  bool const needs_speed = !rapid && feed_per_revolution_;
  if (needs_speed && !(speed_.value_or(0) > 0)) {
    refuse(first_coordinate_, says::cannot_simulate_speed);
    speed_ = 1;
  }
  double const minutes = channel_.cycle_time.seconds() / 60;
  next_.feed =
      rapid ? std::numeric_limits<double>::infinity() : *feed_ * (needs_speed ? *speed_ : 1) * minutes;
  if (next_.label.empty()) next_.label = "L" + std::to_string(next_.line);
  bool const is_possible = make_arc();
  to_center_ = {};
  radius_.reset();
  if (!is_possible) return;
  position_ = next_.end;
  listener_.motion(next_);
  if (exact_stop_ || exact_stop_once_) listener_.stop(0);
  exact_stop_once_ = false;
}

/// False where the block says no circle that could be followed.
bool ProgramInterpreter::make_arc() {
  next_.arc = nullptr;
  bool const asks = radius_ || std::any_of(to_center_.begin(), to_center_.end(),
                                           [](auto const& x) { return x.has_value(); });
  if (motion_ != Motion::clockwise && motion_ != Motion::counterclockwise) {
    if (asks) refuse(first_arc_word_, says::cannot_simulate_no_arc);
    return !asks;
  }
  auto const axis_of = [this](char letter) {
    auto const found = std::find_if(channel_.axes.begin(), channel_.axes.end(),
                                    [letter](std::string const& name) { return name.front() == letter; });
    return static_cast<std::size_t>(found - channel_.axes.begin());
  };
  ArcWords words;
  words.first = axis_of(plane_first_);
  words.second = axis_of(plane_second_);
  if (std::max(words.first, words.second) >= channel_.axes.size()) {
    refuse(first_coordinate_, says::cannot_simulate_plane);
    return false;
  }
  words.clockwise = motion_ == Motion::clockwise;
  words.to_center_first = to_center_.at(static_cast<std::size_t>(plane_first_ - 'X'));
  words.to_center_second = to_center_.at(static_cast<std::size_t>(plane_second_ - 'X'));
  words.radius = radius_;
  auto found = arc_of(words, position_, next_.end);
  if (auto const* const mistake = std::get_if<ArcMistake>(&found)) {
    refuse(first_coordinate_, sentence_of(*mistake));
    return false;
  }
  next_.arc = std::make_shared<Arc const>(std::get<Arc>(found));
  return true;
}

void ProgramInterpreter::end() {
  ended_ = true;
  listener_.end();
}

std::optional<std::size_t> ProgramInterpreter::axis(std::string_view name) const {
  auto const found = std::find(channel_.axes.begin(), channel_.axes.end(), name);
  if (found == channel_.axes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - channel_.axes.begin());
}

void ProgramInterpreter::report(Token const& token, Code code, SentenceRef message,
                                std::vector<Argument> arguments) {
  ProgramProblem problem;
  problem.finding.code = code;
  problem.finding.severity = code == not_simulated ? Severity::warning : Severity::error;
  problem.finding.name = code == not_simulated     ? "not-simulated"
                         : code == cannot_simulate ? "cannot-simulate"
                                                   : "";
  arguments.push_back({.name = "word", .value = std::string(text(token.span))});
  problem.finding.message = {.sentence = message, .arguments = std::move(arguments)};
  problem.line = token.line;
  std::size_t const at = token.span.begin - kept_offset_;
  std::size_t const begin = at == 0 ? 0 : kept_.rfind('\n', at - 1) + 1;
  std::size_t const line_end = std::min(kept_.find('\n', at), kept_.size());
  problem.line_text = kept_.substr(begin, line_end - begin);
  problem.span = {.begin = static_cast<std::uint32_t>(at - begin),
                  .end = static_cast<std::uint32_t>(at - begin + token.span.size())};
  problem_(std::move(problem));
}

void ProgramInterpreter::ignore(Token const& token, std::string const& key, SentenceRef text,
                                std::vector<Argument> arguments) {
  constexpr std::size_t most_named = 100;
  if (ignored_.size() < most_named && ignored_.insert(key).second) {
    report(token, not_simulated, text, std::move(arguments));
  }
}

/// One mistake gives one message: the rest of its block is left alone.
void ProgramInterpreter::refuse(Token const& token, SentenceRef text) {
  refused_ = true;
  broken_ = broken_ || repeats_;
  report(token, cannot_simulate, text);
}

}  // namespace axisc::motion
