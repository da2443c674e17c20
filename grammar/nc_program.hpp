// An NC program as its commands with spans, or as its words for callers that follow them.
//
// A program is read line by line, whatever its length: a line knows of the one before only through an open
// `#COMMENT BEGIN`, or through a `\` at its end, which lets its block continue. A mistake in a command never
// hides another line. A comment, `( … )` or `; …`, may be in every gap; text in a comment or in a string is
// not a command.
#pragma once

#include "diagnostics/span.hpp"
#include "grammar/directive.hpp"
#include "grammar/nc_command.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::grammar {

enum class WordKind : std::uint8_t {
  skip,          ///< `/` or `/3` at the start of a block
  block_number,  ///< N10, at the start of a block or after `/`
  program,       ///< %MAIN, %L UP1: a program or a local subprogram begins
  control,       ///< $IF
  address,       ///< G01, X-10.5, F4000, P10
  name,          ///< LL, UP1, V.P.LENGTH, X1 in `X1=5`
  number,        ///< 20, .5
  text,          ///< "…", up to the line's end where it is not closed
  other,         ///< any other byte
};

struct Word {
  WordKind kind{};
  Span span;
  std::uint32_t line = 0;  ///< from 1
};

/// Receives the parts of a program in the order of its text.
class ProgramListener {
 public:
  virtual ~ProgramListener() = default;
  virtual void word(Word const& word) = 0;
  virtual void command(NcCommand command) = 0;
  virtual void directive(Directive const& directive) = 0;
  /// After the last part of a block.
  virtual void end_of_block() {}

 protected:
  ProgramListener() = default;
  ProgramListener(ProgramListener const&) = default;
  ProgramListener& operator=(ProgramListener const&) = default;
};

enum class ProgramDetail : std::uint8_t {
  commands,  ///< no words, except those of blocks with a function that is wanted
  words,
};

/// Whether the checks look at a G word, by its number.
using WantsFunction = bool (*)(int number);

/// Reads a program line by line in constant memory: the state is the comment or the block that is open.
class ProgramReader {
 public:
  ProgramReader(ProgramListener& listener, ProgramDetail detail, WantsFunction wants = nullptr)
      : listener_(listener), detail_(detail), wants_(wants) {}

  /// The next line without its line end; `offset` is its place in the program, from which all spans count.
  /// `text` may change afterwards.
  void line(std::string_view text, std::uint32_t offset);
  /// After the last line.
  void finish();
  /// A block that began on an earlier line continues with the next one.
  [[nodiscard]] bool block_is_open() const { return !open_block_.empty(); }

 private:
  void continue_block(std::string_view text, std::uint32_t offset, bool goes_on);
  void block(std::string_view text, std::uint32_t offset, std::uint32_t line);
  [[nodiscard]] bool names_wanted(std::string_view text) const;
  void find_directives(std::string_view text, std::uint32_t offset);

  ProgramListener& listener_;
  ProgramDetail detail_;
  WantsFunction wants_;
  std::uint32_t number_ = 0;  ///< of the line read last
  bool in_comment_ = false;   ///< after #COMMENT BEGIN
  std::string open_block_;    ///< the lines of a block that continues, with blanks for other text
  std::uint32_t open_offset_ = 0;
  std::uint32_t open_line_ = 0;
};

/// A block with a G word that the checks look at, or with #SLOPE: its words, and its commands by their first
/// word.
struct WantedBlock {
  std::vector<Word> words;
};

/// The parts of a program that the checks look at: only these are kept, however long it is.
struct NcProgram {
  std::vector<NcCommand> commands;  ///< of kind `other` only those that resemble a filter command
  std::vector<WantedBlock> blocks;  ///< the first most_wanted_blocks of them
  std::vector<Directive> directives;
  std::uint32_t lines = 0;
};

inline constexpr std::size_t most_wanted_blocks = 1000;

/// Receives the parts that an NcProgram keeps.
class ProgramCollector final : public ProgramListener {
 public:
  void word(Word const& word) override { block_.push_back(word); }
  void command(NcCommand command) override;
  void directive(Directive const& directive) override { program.directives.push_back(directive); }
  void end_of_block() override;

  NcProgram program;

 private:
  std::vector<Word> block_;  ///< of a block that is wanted
};

/// `bytes` without byte order mark begins at `text_begin`. Cost: one pass.
[[nodiscard]] NcProgram parse_nc_program(std::string_view bytes, std::uint32_t text_begin,
                                         WantsFunction wants = nullptr);

}  // namespace axisc::grammar
