// Any bytes as an NC program: every span lies inside the text, commands and words come in the order of the
// text, the reader that skips words finds the same commands, and what a command asks for can be said in any
// channel.
#include "grammar/line_splitter.hpp"
#include "grammar/nc_program.hpp"
#include "grammar/program_excerpt.hpp"
#include "validator/commands/command_check.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using axisc::Span;
using namespace axisc::grammar;

void require(bool condition) {
  if (!condition) std::abort();
}

class Checker final : public ProgramListener {
 public:
  explicit Checker(std::string_view bytes) : bytes_(bytes) {}

  void word(Word const& word) override {
    check_span(word.span);
    require(!word.span.empty() && word.span.begin >= behind_ && word.line >= 1);
    behind_ = word.span.end;
  }

  void command(NcCommand command) override {
    check_span(command.name);
    require(bytes_[command.name.begin] == '#' && command.name.begin >= behind_ && command.line >= 1);
    behind_ = command.name.end;
    for (Keyword const& keyword : command.keywords) {
      check_span(keyword.name);
      check_span(keyword.value);
      require(!keyword.name.empty() && keyword.name.begin >= behind_ &&
              keyword.value.begin >= keyword.name.end);
      behind_ = keyword.name.end;
    }
    if (command.problem) {
      check_span(command.problem->span);
      require(!command.problem->span.empty());
    }
    check_span(command.resembling);
    if (is_of_interest(command)) commands.push_back(std::move(command));
  }

  void directive(Directive const& directive) override { check_span(directive.comment); }

  std::vector<NcCommand> commands;

 private:
  void check_span(Span span) const { require(span.begin <= span.end && span.end <= bytes_.size()); }

  std::string_view bytes_;
  std::uint32_t behind_ = 0;
};

void check_meaning(NcCommand const& command, std::string_view bytes) {
  using namespace axisc;
  using namespace axisc::validator;
  if (command.kind == CommandKind::axis_exchange) return;
  for (bool const time_delay : {false, true}) {
    CommandLimits const limits{.cycle_time = {1'000'000}, .time_delay = time_delay};
    CheckedCommand const checked = check_command(command, bytes, limits, Variables::accepted);
    for (CommandMistake const& mistake : checked.mistakes) require(mistake.span.end <= bytes.size());
    if (!checked.command) continue;
    machine::FilterParameters const& parameters = checked.command->parameters;
    require(!parameters.order || *parameters.order <= limits.longest_order());
    require(!parameters.share_percent ||
            (*parameters.share_percent >= 0 && *parameters.share_percent <= 100));
    // What a command asks for can be written as a command that asks for it.
    if (checked.command->hsc) continue;
    std::string const again =
        std::string(parameters.guard ? "#VIB GUARD" : "#FILTER") + " [" + to_text(parameters) + "]";
    CheckedCommand const same = parse_filter_command(again, limits);
    require(same.mistakes.empty() && same.command && same.command->parameters == parameters);
  }
}

/// What an excerpt keeps of a text: its lines end in LF alone.
std::string with_line_feeds(std::string_view text) {
  std::string lines;
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool const ends_line = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (!ends_line) lines += text[i];
  }
  return lines;
}

/// What is kept of a long program says the same as the whole of it.
void check_excerpt(NcProgram const& whole, std::string_view bytes) {
  ProgramExcerptReader reader;
  LineSplitter splitter(bytes);
  for (std::string_view line; splitter.next(line);) reader.line(line);
  reader.finish();
  NcProgram const& part = reader.program();
  require(part.commands.size() == whole.commands.size() && part.directives.size() == whole.directives.size());
  require(part.lines == whole.lines);
  for (std::size_t i = 0; i < whole.commands.size(); ++i) {
    Span const in_part = part.commands[i].name;
    Span const in_whole = whole.commands[i].name;
    require(part.commands[i].line == whole.commands[i].line && in_part.end <= reader.bytes().size());
    require(std::string_view(reader.bytes()).substr(in_part.begin, in_part.size()) ==
            with_line_feeds(bytes.substr(in_whole.begin, in_whole.size())));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  Checker checker(bytes);
  ProgramReader reader(checker, ProgramDetail::words);
  std::uint32_t begin = 0;
  while (begin < bytes.size()) {
    std::size_t const end = std::min(bytes.find('\n', begin), bytes.size());
    std::string_view line = bytes.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    reader.line(line, begin);
    begin = static_cast<std::uint32_t>(end + 1);
  }
  reader.finish();
  NcProgram const program = parse_nc_program(bytes, 0);
  require(program.commands.size() == checker.commands.size());
  for (std::size_t i = 0; i < program.commands.size(); ++i) {
    require(program.commands[i].name == checker.commands[i].name);
    check_meaning(program.commands[i], bytes);
  }
  check_excerpt(program, bytes);
  return 0;
}
