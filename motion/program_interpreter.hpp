// What an NC program says about the path, in the subset that a simulation follows: block numbers, comments, G00, G01, G90,
// G91, axis words, F, #SLOPE [TYPE=TRAPEZ], #FILTER and M30.
//
// Words outside of it become problems: those that change neither path nor filters are ignored, at their first place with a
// warning (AX9007); all others are refused (AX9008).
#pragma once

#include "diagnostics/finding.hpp"
#include "grammar/nc_program.hpp"
#include "machine/filter_command.hpp"
#include "motion/path_block.hpp"
#include "motion/sentences.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
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
  bool inch = false;
  design::CycleTime cycle_time;
  FilterCommandReader read_filter_command;
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

  void block();
  std::size_t take(std::size_t at);
  std::size_t take_address(std::size_t at);
  std::size_t take_command(std::size_t at);
  std::size_t take_assignment(std::size_t at);
  void take_function(Token const& token, std::string_view digits);
  void take_coordinate(Token const& token, std::size_t axis, std::string_view number);
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

  ProgrammedBlock next_;  ///< what the block says so far
  Point position_{};
  bool moves_ = false;
  bool rapid_ = false;
  bool incremental_ = false;
  bool ended_ = false;
  bool dwells_ = false;   ///< numbers of the block are no positions
  bool refused_ = false;  ///< the block
  Token first_coordinate_;
  std::optional<double> feed_;  ///< units per cycle
};

}  // namespace axisc::motion
