// What an NC program says about the path, in the subset that a simulation follows; docs/nc-programs.md has the table.
//
// Words outside of it become problems: those that change neither path nor filters are ignored, at their first place with a
// warning (AX9007); all others are refused (AX9008).
//
// Blocks are executed as they come and forgotten. Kept are those of subprograms and of the loop that is open
// (program_flow.cpp).
#pragma once

#include "diagnostics/finding.hpp"
#include "grammar/nc_program.hpp"
#include "machine/filter_command.hpp"
#include "motion/arc_words.hpp"
#include "motion/path_block.hpp"
#include "motion/sentences.hpp"

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::motion {

/// A #FILTER command.
struct FilterChange {
  machine::FilterCommand command;
  std::optional<double> tolerance;  ///< AX_DEV in position units
  std::string text;                 ///< as the program writes it, blanks and comments around it left out
  std::uint32_t line = 0;
};

class PathListener {
 public:
  virtual ~PathListener() = default;
  virtual void motion(ProgrammedBlock const& block) = 0;
  virtual void command(FilterChange const& change) = 0;
  /// The path stops here; it goes on when the filters have settled, and after so many cycles at the earliest.
  virtual void stop(double /*cycles*/) {}
  virtual void end() = 0;

 protected:
  PathListener() = default;
  PathListener(PathListener const&) = default;
  PathListener& operator=(PathListener const&) = default;
};

/// A place that the simulation does not follow.
struct ProgramProblem {
  Finding finding;  ///< without place
  std::uint32_t line = 0;
  std::string line_text;  ///< the whole line
  Span span;              ///< in it
};

/// What a #FILTER command asks for, or what is wrong with it. Spans count like those of the command.
struct FilterCommandReading {
  struct Mistake {
    Code code{};
    Span span;
    Message message;
  };
  std::optional<machine::FilterCommand> command;
  std::vector<Mistake> mistakes;
};

/// Reads a command, whose spans count from the start of the text.
using FilterCommandReader = std::function<FilterCommandReading(grammar::NcCommand const&, std::string_view)>;

/// The channel that runs the program.
struct ProgramChannel {
  std::vector<std::string> axes;
  std::vector<bool> rotary;  ///< lengths of these are degrees, whatever the program's unit
  bool inch = false;         ///< where the program says nothing else
  design::CycleTime cycle_time;
  FilterCommandReader read_filter_command;
  /// Blocks of loops and subprograms that are executed at most: an endless loop ends there.
  std::uint64_t most_repeated_blocks = 10'000'000;
};

class ProgramInterpreter final : private grammar::ProgramListener {
 public:
  ProgramInterpreter(ProgramChannel channel, PathListener& listener,
                     std::function<void(ProgramProblem)> problem);

  /// The next line without its line end; `offset` is its place in the program. False behind the end of the program.
  bool line(std::string_view text, std::uint32_t offset);
  /// Behind the last line.
  void finish();

 private:
  struct Token {
    grammar::WordKind kind{};
    Span span;
    std::uint32_t line = 0;
    std::optional<std::size_t> command;  ///< index into commands_
  };

  void word(grammar::Word const& word) override;
  void command(grammar::NcCommand command) override;
  void directive(grammar::Directive const& /*directive*/) override {}

  /// A block that is executed later, or more than once.
  struct KeptBlock {
    std::string text;  ///< its lines
    std::uint32_t offset = 0;
    std::vector<Token> tokens;
    std::vector<grammar::NcCommand> commands;
  };
  using KeptBlocks = std::span<KeptBlock const>;
  /// Why the blocks of a loop or subprogram are left.
  enum class Leaves : std::uint8_t { nothing, round, loop, subprogram };
  struct Condition {
    bool holds = false;  ///< the blocks that follow are executed
    bool held = false;   ///< this branch or an earlier one
    KeptBlock opening;
  };

  void next_block();
  bool keep_for_later();
  [[nodiscard]] KeptBlock kept_block() const;
  void execute(KeptBlock const& kept);
  template <typename Action>
  void with_block(KeptBlock const& block, Action action);
  void run(KeptBlocks blocks);
  void run_loop(KeptBlocks loop);
  [[nodiscard]] bool next_round(Token const& loop, std::uint64_t rounds);
  void count_repeated();
  bool take_condition();
  void call(std::size_t at);
  void refuse_open_blocks();
  [[nodiscard]] std::size_t first_word() const;
  [[nodiscard]] std::string_view control() const;
  [[nodiscard]] bool is_active() const { return conditions_.empty() || conditions_.back().holds; }
  std::optional<double> evaluate(Token const& token, std::uint32_t& begin);
  [[nodiscard]] double evaluate_all(std::size_t at);

  void block();
  std::size_t take(std::size_t at);
  std::size_t take_address(std::size_t at);
  std::size_t take_command(std::size_t at);
  std::size_t take_assignment(std::size_t at);
  void take_function(Token const& token, std::string_view digits);
  /// F, S, I, J, K, R or an axis with its number.
  void take_value(Token const& token, std::string_view name, double value);
  void take_coordinate(Token const& token, std::size_t axis, double value);
  void take_arc_word(Token const& token, std::optional<double>& word, double length);
  void take_feed(Token const& token, double value);
  void take_dwell(Token const& token, double seconds);
  void take_slope(Token const& token, std::string_view written);
  [[nodiscard]] bool make_arc();
  void take_filter(Token const& token);
  void move();
  void end();

  void keep(std::string_view text, std::uint32_t offset);
  [[nodiscard]] std::string_view text(Span span) const;
  [[nodiscard]] std::optional<std::size_t> axis(std::string_view name) const;
  void report(Token const& token, Code code, SentenceRef message, std::vector<Argument> arguments = {});
  void ignore(Token const& token, std::string const& key, SentenceRef text,
              std::vector<Argument> arguments = {});
  void refuse(Token const& token, SentenceRef text = says::cannot_simulate);

  ProgramChannel channel_;
  PathListener& listener_;
  std::function<void(ProgramProblem)> problem_;
  grammar::ProgramReader reader_;

  std::string kept_;  ///< the lines read last, longer than any block
  std::uint32_t kept_offset_ = 0;
  std::vector<Token> tokens_;  ///< of the block
  std::vector<grammar::NcCommand> commands_;
  std::set<std::string> ignored_;

  std::map<std::string, std::vector<KeptBlock>, std::less<>> subprograms_;
  std::vector<KeptBlock>* subprogram_ = nullptr;  ///< that is being read
  KeptBlock subprogram_begin_;                    ///< its %L
  int subprogram_depth_ = 0;
  std::vector<KeptBlock> loop_;  ///< that is being read
  int loop_depth_ = 0;
  std::vector<Condition> conditions_;  ///< those that are open
  std::map<std::string, double, std::less<>> variables_;
  Leaves leaves_ = Leaves::nothing;
  bool repeats_ = false;  ///< blocks are executed that were kept
  bool broken_ = false;   ///< one of them had a mistake
  int depth_ = 0;         ///< of loops and subprograms
  int calls_ = 0;         ///< subprograms that are open
  std::uint64_t repeated_ = 0;

  ProgrammedBlock next_;  ///< what the block says so far
  Point position_{};
  bool moves_ = false;
  std::bitset<most_axes> moved_;  ///< axes that the block names
  std::array<std::optional<int>, 7>
      chosen_{};  ///< of each group that excludes others, the G word of the block
  enum class Motion : std::uint8_t { rapid, line, clockwise, counterclockwise };
  Motion motion_ = Motion::line;
  bool incremental_ = false;
  bool inch_ = false;
  char plane_first_ = 'X', plane_second_ = 'Y';
  std::array<std::optional<double>, 3> to_center_;  ///< I, J, K of the block
  std::optional<double> radius_;                    ///< R of the block
  bool exact_stop_ = false, exact_stop_once_ = false;
  std::optional<double> dwell_;  ///< of the block, cycles
  Token first_dwell_;
  bool ended_ = false;
  bool dwells_ = false;   ///< numbers of the block are no positions
  bool refused_ = false;  ///< the block
  Token first_coordinate_, first_arc_word_;
  std::optional<double> feed_;  ///< units per minute, or per revolution
  bool feed_per_revolution_ = false;
  std::optional<double> speed_;  ///< revolutions per minute
};

}  // namespace axisc::motion
