#include "grammar/nc_program.hpp"

#include "diagnostics/ascii.hpp"
#include "grammar/line_splitter.hpp"
#include "grammar/nc_program_def.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace axisc::grammar {
namespace {

/// A block that continues for longer than this ends at the line that reached it; a block may be as long as a
/// line may be.
constexpr std::size_t longest_block = 1U << 20U;

/// Runs one parser from `first` on; afterwards `first` is after the match.
template <typename Parser, typename Attribute>
bool parse(Parser const& parser, char const*& first, char const* last, Attribute& attribute) {
  return parser.parse(first, last, x3::unused, x3::unused, attribute);
}

template <typename Parser>
bool begins_with(Parser const& parser, std::string_view line) {
  char const* first = line.data();
  return parser.parse(first, line.data() + line.size(), x3::unused, x3::unused, x3::unused);
}

/// Calls `found` with every comment of a line, strings left out.
template <typename Found>
void for_each_comment(std::string_view line, Found found) {
  char const* const end = line.data() + line.size();
  for (char const* position = line.data(); position != end;) {
    if (*position == '"') {
      position = std::find(position + 1, end, '"');
      if (position != end) ++position;
    } else if (opens_comment(*position)) {
      char const* const behind = behind_comment(position, end);
      found(std::string_view(position, static_cast<std::size_t>(behind - position)));
      position = behind;
    } else {
      ++position;
    }
  }
}

/// True if the line holds nothing but blanks, comments and a block number.
bool says_nothing(std::string_view line) {
  using namespace block_syntax;
  return begins_with(gap >> -block_number >> gap >> eoi, line);
}

/// The line without the `\` that ends it outside of comments and strings; the whole line where there is none.
std::string_view without_continuation(std::string_view line) {
  std::size_t const last = line.find_last_not_of(" \t");
  if (last == std::string_view::npos || line[last] != '\\') return line;
  bool quoted = false;
  for (char const* position = line.data(); position != line.data() + last;) {
    if (*position == '"') quoted = !quoted;
    if (!quoted && opens_comment(*position)) {
      position = behind_comment(position, line.data() + line.size());
      if (position > line.data() + last) return line;
    } else {
      ++position;
    }
  }
  return quoted ? line : line.substr(0, last);
}

}  // namespace

void ProgramReader::line(std::string_view text, std::uint32_t offset) {
  ++number_;
  bool const has_command = text.find('#') != std::string_view::npos;
  if (in_comment_) {
    if (has_command) in_comment_ = !begins_with(block_syntax::comment_end, text);
    return;
  }
  find_directives(text, offset);
  if (has_command && begins_with(block_syntax::comment_begin, text)) {
    finish();
    in_comment_ = true;
    return;
  }
  std::string_view const kept = without_continuation(text);
  bool const goes_on = kept.size() != text.size();
  if (goes_on || !open_block_.empty()) {
    continue_block(kept, offset, goes_on || says_nothing(text));
  } else if (has_command || detail_ == ProgramDetail::words || names_wanted(text)) {
    block(text, offset, number_);
  }
}

void ProgramReader::finish() {
  if (open_block_.empty()) return;
  std::string const whole = std::exchange(open_block_, {});
  block(whole, open_offset_, open_line_);
}

void ProgramReader::continue_block(std::string_view text, std::uint32_t offset, bool goes_on) {
  if (open_block_.empty()) {
    open_offset_ = offset;
    open_line_ = number_;
  } else {
    // Offsets stay those of the program: blanks replace `\` and CR, and the line's end is the last byte
    // before `text`.
    open_block_.resize(offset - open_offset_ - 1, ' ');
    open_block_ += '\n';
  }
  open_block_ += text;
  if (!goes_on || open_block_.size() > longest_block) finish();
}

/// A comment may name one as well, which costs time and nothing else.
bool ProgramReader::names_wanted(std::string_view text) const {
  if (wants_ == nullptr) return false;
  if (text.find("SLOPE") != std::string_view::npos) return true;
  for (std::size_t at = text.find('G'); at != std::string_view::npos; at = text.find('G', at + 1)) {
    constexpr int most = 1000;
    int number = 0;
    std::size_t digit = at + 1;
    for (; digit < text.size() && ascii::is_digit(text[digit]) && number < most; ++digit) {
      number = number * 10 + (text[digit] - '0');
    }
    if (digit > at + 1 && wants_(number)) return true;
  }
  return false;
}

void ProgramReader::block(std::string_view text, std::uint32_t offset, std::uint32_t line) {
  bool const passes_words = detail_ == ProgramDetail::words || names_wanted(text);
  char const* position = text.data();
  char const* const end = text.data() + text.size();
  char const* counted = position;
  bool at_start = true;
  while (true) {
    parse(block_syntax::gap, position, end, x3::unused);
    if (position == end) return listener_.end_of_block();
    line += static_cast<std::uint32_t>(std::count(counted, position, '\n'));
    counted = position;
    if (*position == '#') {
      auto at = static_cast<std::size_t>(position - text.data());
      NcCommand command = read_nc_command(text, at, offset);
      position = text.data() + at;
      command.line = line;
      listener_.command(std::move(command));
      at_start = false;
      continue;
    }
    block_syntax::WordToken token;
    if (!at_start || !parse(block_syntax::block_start, position, end, token)) {
      parse(block_syntax::word, position, end, token);
    }
    at_start = token.kind == WordKind::skip;
    if (!passes_words) continue;
    std::uint32_t const begin = offset + static_cast<std::uint32_t>(token.text.begin() - text.data());
    listener_.word({.kind = token.kind,
                    .span = {.begin = begin, .end = begin + static_cast<std::uint32_t>(token.text.size())},
                    .line = line});
  }
}

void ProgramReader::find_directives(std::string_view text, std::uint32_t offset) {
  if (text.find(directive_introducer) == std::string_view::npos) return;
  bool const whole_line = says_nothing(text);
  for_each_comment(text, [&](std::string_view comment) {
    if (comment.find(directive_introducer) == std::string_view::npos) return;
    std::uint32_t const begin = offset + static_cast<std::uint32_t>(comment.data() - text.data());
    listener_.directive(
        {.comment = {.begin = begin, .end = begin + static_cast<std::uint32_t>(comment.size())},
         .whole_line = whole_line,
         .line = number_});
  });
}

void ProgramCollector::command(NcCommand command) {
  if (!block_.empty() || command.kind == CommandKind::other) {
    block_.push_back({.kind = WordKind::other, .span = command.name, .line = command.line});
  }
  if (is_of_interest(command)) program.commands.push_back(std::move(command));
}

void ProgramCollector::end_of_block() {
  // A command alone came without words: its block is not wanted.
  if (block_.size() > 1 && program.blocks.size() < most_wanted_blocks) {
    program.blocks.push_back({.words = std::move(block_)});
  }
  block_.clear();
}

NcProgram parse_nc_program(std::string_view bytes, std::uint32_t text_begin, WantsFunction wants) {
  ProgramCollector collector;
  ProgramReader reader(collector, ProgramDetail::commands, wants);
  LineSplitter splitter(bytes.substr(text_begin));
  for (std::string_view line; splitter.next(line);) {
    reader.line(line, static_cast<std::uint32_t>(line.data() - bytes.data()));
  }
  reader.finish();
  collector.program.lines = splitter.number();
  return std::move(collector.program);
}

}  // namespace axisc::grammar
