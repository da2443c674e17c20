// The order in which a program's blocks are executed: conditions, loops, subprograms, and the variables that decide.
#include "grammar/expression.hpp"
#include "motion/program_interpreter.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace axisc::motion::says {

constexpr Sentence cannot_simulate_expression{
    "the simulation cannot compute this: it knows numbers, P1, V.P.NAME with a value, + - * / [ ], "
    "comparisons, AND, "
    "OR and ABS, SQRT, SIN, COS, TAN, INT, NOT",
    "die Simulation kann das nicht berechnen: sie kennt Zahlen, P1, V.P.NAME mit einem Wert, + - * / [ ], "
    "Vergleiche, "
    "AND, OR und ABS, SQRT, SIN, COS, TAN, INT, NOT"};
constexpr Sentence cannot_simulate_control{"`{word}` cannot be simulated here",
                                           "`{word}` ist hier nicht simulierbar"};
constexpr Sentence cannot_simulate_open{"`{word}` is not closed", "`{word}` wird nicht geschlossen"};
constexpr Sentence cannot_simulate_endless{
    "`{word}`: the repetition does not end within the blocks that the simulation executes",
    "`{word}`: die Wiederholung endet nicht innerhalb der Sätze, die die Simulation ausführt"};
constexpr Sentence cannot_simulate_depth{"`{word}`: loops and subprograms are nested too deeply",
                                         "`{word}`: Schleifen und Unterprogramme sind zu tief verschachtelt"};
constexpr Sentence cannot_simulate_call{
    "`{word}`: the program has no such subprogram (%L) before this place",
    "`{word}`: das Programm hat vor dieser Stelle kein solches Unterprogramm (%L)"};
constexpr Sentence cannot_simulate_file{
    "`{word}`: subprograms in other files are not read; put it before the program with %L, and call it with "
    "LL",
    "`{word}`: Unterprogramme in anderen Dateien werden nicht gelesen; mit %L vor das Programm schreiben und "
    "mit LL "
    "rufen"};

}  // namespace axisc::motion::says

namespace axisc::motion {
namespace {

using grammar::WordKind;

constexpr int deepest = 40;
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> loops = {
    {{"$FOR", "$ENDFOR"}, {"$WHILE", "$ENDWHILE"}, {"$REPEAT", "$UNTIL"}}};

bool opens_loop(std::string_view word) {
  return std::any_of(loops.begin(), loops.end(), [word](auto const& loop) { return loop.first == word; });
}

bool closes_loop(std::string_view word) {
  return std::any_of(loops.begin(), loops.end(), [word](auto const& loop) { return loop.second == word; });
}

}  // namespace

/// Behind what may stand before every block.
std::size_t ProgramInterpreter::first_word() const {
  std::size_t at = 0;
  while (at < tokens_.size() &&
         (tokens_[at].kind == WordKind::skip || tokens_[at].kind == WordKind::block_number)) {
    ++at;
  }
  return at;
}

/// `$IF` where the block begins with it, or nothing.
std::string_view ProgramInterpreter::control() const {
  auto const at = first_word();
  bool const is_control = at < tokens_.size() && tokens_[at].kind == WordKind::control;
  return is_control ? text(tokens_[at].span) : std::string_view();
}

ProgramInterpreter::KeptBlock ProgramInterpreter::kept_block() const {
  std::size_t const at = tokens_.front().span.begin - kept_offset_;
  std::size_t const begin = at == 0 ? 0 : kept_.rfind('\n', at - 1) + 1;
  return {.text = kept_.substr(begin),
          .offset = kept_offset_ + static_cast<std::uint32_t>(begin),
          .tokens = tokens_,
          .commands = commands_};
}

/// What was read last: executed, or kept for later.
void ProgramInterpreter::next_block() {
  if (tokens_.empty()) return;
  if (!keep_for_later()) {
    if (!take_condition()) block();
  }
  tokens_.clear();
  commands_.clear();
}

bool ProgramInterpreter::keep_for_later() {
  auto const at = first_word();
  if (at == tokens_.size()) return false;
  if (tokens_[at].kind == WordKind::program) {
    std::string_view name = text(tokens_[at].span);
    subprogram_ = nullptr;
    // %LENGTHS is a program of that name.
    bool const is_subprogram = name == "%L" || name.starts_with("%L ") || name.starts_with("%L\t");
    if (!is_subprogram) return false;
    name.remove_prefix(2);
    name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
    if (loop_depth_ > 0 || name.empty()) {
      refuse(tokens_[at]);
      return true;
    }
    subprogram_ = &subprograms_[std::string(name)];
    subprogram_->clear();
    subprogram_begin_ = kept_block();
    subprogram_depth_ = 0;
    return true;
  }
  if (subprogram_ != nullptr) {
    subprogram_->push_back(kept_block());
    auto const word = control();
    if (word == "$IF" || opens_loop(word)) ++subprogram_depth_;
    if (word == "$ENDIF" || closes_loop(word)) --subprogram_depth_;
    bool const ends = std::any_of(tokens_.begin(), tokens_.end(), [this](Token const& token) {
      auto const written = text(token.span);
      return token.kind == WordKind::address && (written == "M17" || written == "M29");
    });
    // In a condition it is not the last block.
    if (ends && subprogram_depth_ <= 0) subprogram_ = nullptr;
    return true;
  }
  auto const word = control();
  bool const begins = loop_depth_ == 0 && is_active() && opens_loop(word);
  if (!begins && loop_depth_ == 0) return false;
  if (opens_loop(word)) ++loop_depth_;
  if (closes_loop(word)) --loop_depth_;
  loop_.push_back(kept_block());
  if (loop_depth_ > 0) return true;
  auto const loop = std::exchange(loop_, {});
  run(loop);
  leaves_ = Leaves::nothing;
  return true;
}

/// Executes with a kept block in place of the one that was read.
template <typename Action>
void ProgramInterpreter::with_block(KeptBlock const& block, Action action) {
  auto text = std::exchange(kept_, block.text);
  auto const offset = std::exchange(kept_offset_, block.offset);
  auto tokens = std::exchange(tokens_, block.tokens);
  auto commands = std::exchange(commands_, block.commands);
  bool const repeats = std::exchange(repeats_, true);
  action();
  kept_ = std::move(text);
  kept_offset_ = offset;
  tokens_ = std::move(tokens);
  commands_ = std::move(commands);
  repeats_ = repeats;
}

void ProgramInterpreter::count_repeated() {
  if (++repeated_ == channel_.most_repeated_blocks) refuse(tokens_.front(), says::cannot_simulate_endless);
}

void ProgramInterpreter::execute(KeptBlock const& kept) {
  with_block(kept, [this] {
    count_repeated();
    if (!broken_ && !take_condition()) block();
  });
}

void ProgramInterpreter::run(KeptBlocks blocks) {
  auto const open = conditions_.size();
  ++depth_;
  for (std::size_t i = 0; i < blocks.size() && !ended_ && !broken_ && leaves_ == Leaves::nothing; ++i) {
    bool loop = false;
    with_block(blocks[i], [&] {
      loop = is_active() && opens_loop(control());
      if (loop && depth_ > deepest) refuse(tokens_[first_word()], says::cannot_simulate_depth);
    });
    if (!loop) {
      execute(blocks[i]);
      continue;
    }
    std::size_t end = i;
    int depth = 0;
    do {
      with_block(blocks[end], [&] {
        if (opens_loop(control())) ++depth;
        if (closes_loop(control())) --depth;
      });
    } while (depth > 0 && ++end < blocks.size());
    if (end == blocks.size()) {
      with_block(blocks[i], [&] { refuse(tokens_[first_word()], says::cannot_simulate_open); });
    } else if (!broken_) {
      run_loop(blocks.subspan(i, end - i + 1));
    }
    i = end;
  }
  --depth_;
  if (conditions_.size() > open && leaves_ == Leaves::nothing && !broken_ && !ended_) {
    with_block(KeptBlock(conditions_.back().opening),
               [&] { refuse(tokens_[first_word()], says::cannot_simulate_open); });
  }
  conditions_.resize(std::min(open, conditions_.size()));
}

/// From the block that opens a loop to the one that closes it.
void ProgramInterpreter::run_loop(KeptBlocks loop) {
  std::string opening;
  std::string closing;
  with_block(loop.front(), [&] { opening = control(); });
  with_block(loop.back(), [&] { closing = control(); });
  for (std::uint64_t rounds = 0; !ended_ && !broken_; ++rounds) {
    bool goes_on = false;
    with_block(loop.front(), [&] {
      count_repeated();
      if (std::none_of(loops.begin(), loops.end(),
                       [&](auto const& pair) { return pair.first == opening && pair.second == closing; })) {
        refuse(tokens_[first_word()], says::cannot_simulate_open);
      }
      auto const& token = tokens_[first_word()];
      goes_on = !broken_ && (text(token.span) == "$REPEAT" || next_round(token, rounds));
    });
    if (!goes_on) return;
    run(loop.subspan(1, loop.size() - 2));
    if (leaves_ == Leaves::subprogram || ended_ || broken_) return;
    if (std::exchange(leaves_, Leaves::nothing) == Leaves::loop) return;
    with_block(loop.back(), [&] {
      auto const at = first_word();
      goes_on = text(tokens_[at].span) != "$UNTIL" || evaluate_all(at) == 0;
    });
    if (!goes_on) return;
  }
}

/// $WHILE condition, $FOR P1 = first, last, step
bool ProgramInterpreter::next_round(Token const& loop, std::uint64_t rounds) {
  auto const at = first_word();
  if (text(loop.span) == "$WHILE") return evaluate_all(at) != 0;
  bool const complete = at + 3 < tokens_.size() && text(tokens_[at + 2].span) == "=";
  if (!complete) {
    refuse(loop, says::cannot_simulate_control);
    return false;
  }
  std::string const name(text(tokens_[at + 1].span));
  std::uint32_t place = tokens_[at + 3].span.begin;
  std::array<double, 3> numbers{0, 0, 1};
  std::size_t count = 0;
  while (count < numbers.size()) {
    auto const value = evaluate(loop, place);
    if (!value) return false;
    numbers.at(count++) = *value;
    if (place - kept_offset_ >= kept_.size() || kept_[place - kept_offset_] != ',') break;
    ++place;
  }
  bool const is_variable = name.starts_with("V.P.") || name.front() == 'P';
  bool const more = std::any_of(tokens_.begin(), tokens_.end(),
                                [&](Token const& token) { return token.span.begin >= place; });
  auto const [first, last, step] = numbers;
  if (!is_variable || count < 2 || more || step == 0) {
    refuse(loop, says::cannot_simulate_control);
    return false;
  }
  auto& variable = variables_[name];
  variable = rounds == 0 ? first : variable + step;
  return step > 0 ? variable <= last : variable >= last;
}

/// Conditions and what else decides about the next block; false where the block is one to execute.
bool ProgramInterpreter::take_condition() {
  std::string const word(control());
  if (word.empty()) return !is_active();
  auto const at = first_word();
  Token const token = tokens_[at];
  refused_ = false;
  if (word == "$IF") {
    if (conditions_.size() >= std::size_t{deepest} * 2) {
      refuse(token, says::cannot_simulate_depth);
      return true;
    }
    bool const outer = is_active();
    bool const holds = outer && evaluate_all(at) != 0;
    conditions_.push_back({.holds = holds, .held = holds || !outer, .opening = kept_block()});
    return true;
  }
  bool const branches = word == "$ELSE" || word == "$ELSEIF" || word == "$ENDIF";
  if (branches && !conditions_.empty()) {
    auto& condition = conditions_.back();
    if (word == "$ENDIF") {
      conditions_.pop_back();
    } else {
      bool const holds = !condition.held && (word == "$ELSE" || evaluate_all(at) != 0);
      condition.holds = holds;
      condition.held = condition.held || holds;
    }
    return true;
  }
  if (!is_active()) return true;
  if (word == "$BREAK" && depth_ > 0) {
    leaves_ = Leaves::loop;
  } else if (word == "$CONTINUE" && depth_ > 0) {
    leaves_ = Leaves::round;
  } else {
    refuse(token, says::cannot_simulate_control);
  }
  return true;
}

/// LL NAME
void ProgramInterpreter::call(std::size_t at) {
  Token const token = tokens_[at];
  if (text(token.span) == "L") return refuse(token, says::cannot_simulate_file);
  std::string name;
  if (at + 1 < tokens_.size()) {
    name = text({.begin = tokens_[at + 1].span.begin, .end = tokens_.back().span.end});
  }
  move();
  if (refused_) return;
  auto const found = subprograms_.find(name);
  if (found == subprograms_.end()) return refuse(token, says::cannot_simulate_call);
  if (depth_ >= deepest) return refuse(token, says::cannot_simulate_depth);
  ++calls_;
  run(found->second);
  --calls_;
  leaves_ = Leaves::nothing;
  moves_ = dwells_ = exact_stop_once_ = false;
}

/// The value of the expression at a place, which is behind it afterwards; nothing where it was refused.
std::optional<double> ProgramInterpreter::evaluate(Token const& token, std::uint32_t& begin) {
  std::string_view const rest = std::string_view(kept_).substr(begin - kept_offset_);
  auto const expression = grammar::parse_expression(rest);
  auto const variable = [this](std::string const& name) -> std::optional<double> {
    auto const found = variables_.find(name);
    return found == variables_.end() ? std::nullopt : std::optional(found->second);
  };
  auto const value = expression ? grammar::value_of(*expression, variable) : std::nullopt;
  if (!value) {
    refuse(token, says::cannot_simulate_expression);
    return std::nullopt;
  }
  begin += static_cast<std::uint32_t>(expression->size);
  return value;
}

/// The condition behind a word, which is the rest of its block; 0 where it was refused.
double ProgramInterpreter::evaluate_all(std::size_t at) {
  Token const token = tokens_[at];
  if (at + 1 == tokens_.size()) {
    refuse(token, says::cannot_simulate_control);
    return 0;
  }
  std::uint32_t place = tokens_[at + 1].span.begin;
  auto const value = evaluate(token, place);
  if (value && tokens_.back().span.begin >= place) {
    refuse(token, says::cannot_simulate_expression);
    return 0;
  }
  return value.value_or(0);
}

void ProgramInterpreter::refuse_open_blocks() {
  if (ended_) return;
  if (subprogram_ != nullptr) {
    // Nothing comes behind it: the program would be empty.
    with_block(KeptBlock(subprogram_begin_),
               [this] { refuse(tokens_[first_word()], says::cannot_simulate_open); });
  } else if (!loop_.empty()) {
    with_block(KeptBlock(loop_.front()),
               [this] { refuse(tokens_[first_word()], says::cannot_simulate_open); });
  } else if (!conditions_.empty()) {
    with_block(KeptBlock(conditions_.back().opening),
               [this] { refuse(tokens_[first_word()], says::cannot_simulate_open); });
  }
}

}  // namespace axisc::motion
