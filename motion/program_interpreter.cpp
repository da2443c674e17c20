#include "motion/program_interpreter.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace axisc::motion::says {

constexpr Sentence not_simulated{"the simulation ignores `{word}`", "die Simulation übergeht `{word}`"};
constexpr Sentence not_simulated_axis{"the simulation ignores `{word}`: the channel has no axis {axis}",
                                      "die Simulation übergeht `{word}`: der Kanal hat keine Achse {axis}"};
constexpr Sentence not_simulated_slope{
    "the simulation ignores `{word}`: it plans trapezoidal velocities (TYPE=TRAPEZ)",
    "die Simulation übergeht `{word}`: sie plant trapezförmige Geschwindigkeiten (TYPE=TRAPEZ)"};

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

/// Functions that leave path and filters as they are: dwell, planes, no offsets, exact stop modes, metric, feed per minute.
constexpr std::array<int, 14> harmless = {4, 8, 9, 17, 18, 19, 40, 53, 60, 61, 64, 71, 80, 94};

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
      reader_(*this, grammar::ProgramDetail::words) {}

bool ProgramInterpreter::line(std::string_view text, std::uint32_t offset) {
  if (ended_) return false;
  keep(text, offset);
  reader_.line(text, offset);
  block();
  return !ended_;
}

void ProgramInterpreter::finish() {
  if (ended_) return;
  reader_.finish();
  block();
  end();
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
  dwells_ = false;
  refused_ = false;
  for (std::size_t at = 0; at < tokens_.size() && !ended_ && !refused_;) at = take(at);
  move();
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
      // A local subprogram would only run where it is called.
      if (text(token.span).substr(0, 2) == "%L") refuse(token);
      return at + 1;
    case WordKind::address:
      return take_address(at);
    case WordKind::name:
      return take_assignment(at);
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
  if (letter == 'N') {
    next_.label = word;
  } else if (letter == 'G' || letter == 'M') {
    take_function(token, number);
  } else if (letter == 'F') {
    auto const feed = real_number(number);
    if (!feed) {
      refuse(token, says::cannot_simulate_number);
    } else if (!(*feed > 0)) {
      refuse(token, says::cannot_simulate_feed_range);
    } else {
      double const mm_per_min = *feed * (channel_.inch ? mm_per_inch : 1);
      feed_ = mm_per_min / 60 * channel_.cycle_time.seconds() * units_per_mm;
    }
  } else if (auto const index = axis(word.substr(0, 1))) {
    take_coordinate(token, *index, number);
  } else if (is_geometry_letter(letter)) {
    ignore(token, std::string(1, letter), says::not_simulated_axis, {{"axis", std::string(1, letter)}});
  } else if (is_technology_letter(letter)) {
    ignore(token, std::string(1, letter), says::not_simulated);
  } else {
    refuse(token);
  }
  return at + 1;
}

/// X=5, X1=5: the only assignments that are no variables.
std::size_t ProgramInterpreter::take_assignment(std::size_t at) {
  Token const& token = tokens_[at];
  auto const index = axis(text(token.span));
  bool const complete = at + 2 < tokens_.size() && text(tokens_[at + 1].span) == "=";
  if (!index || !complete || tokens_[at + 2].kind != WordKind::number) {
    refuse(token);
    return tokens_.size();
  }
  take_coordinate(token, *index, text(tokens_[at + 2].span));
  return at + 3;
}

void ProgramInterpreter::take_function(Token const& token, std::string_view digits) {
  bool const is_g = text(token.span).front() == 'G';
  auto const number = whole_number(digits);
  if (!number) return refuse(token);
  if (!is_g) {
    if (*number == 30 || *number == 2) {
      move();
      return end();
    }
    if (*number == 17 || *number == 29) return refuse(token);
    return ignore(token, "M" + std::to_string(*number), says::not_simulated);
  }
  switch (*number) {
    case 0:
    case 1:
      rapid_ = *number == 0;
      return;
    case 90:
    case 91:
      incremental_ = *number == 91;
      return;
    default:
      break;
  }
  if (std::find(harmless.begin(), harmless.end(), *number) == harmless.end()) return refuse(token);
  dwells_ = dwells_ || *number == 4;
  ignore(token, "G" + std::to_string(*number), says::not_simulated);
}

void ProgramInterpreter::take_coordinate(Token const& token, std::size_t axis, std::string_view number) {
  if (dwells_) return;
  auto const value = real_number(number);
  if (!value) return refuse(token, says::cannot_simulate_number);
  double const unit = units_per_mm * (channel_.inch && !channel_.rotary[axis] ? mm_per_inch : 1);
  double const target = (incremental_ ? position_[axis] : 0) + *value * unit;
  if (!(std::abs(target) <= furthest)) return refuse(token, says::cannot_simulate_too_far);
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
  if (written == "#SLOPE[TYPE=TRAPEZ]") return tokens_.size();
  bool const slope = written.rfind("#SLOPE", 0) == 0;
  ignore(token, written, slope ? says::not_simulated_slope : says::not_simulated);
  return tokens_.size();
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
  if (!moves_) return;
  moves_ = false;
  if (!rapid_ && !feed_) {
    refuse(first_coordinate_, says::cannot_simulate_feed);
    feed_ = 1;  // said once
  }
  next_.feed = rapid_ ? std::numeric_limits<double>::infinity() : *feed_;
  if (next_.label.empty()) next_.label = "L" + std::to_string(next_.line);
  position_ = next_.end;
  listener_.motion(next_);
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
  report(token, cannot_simulate, text);
}

}  // namespace axisc::motion
