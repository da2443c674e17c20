#include "analysis/motion/program/filter_change.hpp"

#include "analysis/motion/program/modal_words.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::motion {
namespace {

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

/// From its name to the last keyword and the bracket after it.
std::string text_of(grammar::NcCommand const& command, std::string_view lines) {
  std::uint32_t last = command.name.end;
  for (auto const& keyword : command.keywords) {
    last = std::max({last, keyword.name.end, keyword.value.end});
  }
  auto const bracket = lines.find(']', last);
  bool const has_bracket = bracket != std::string_view::npos && bracket < lines.find('\n', last);
  auto const end = has_bracket ? bracket + 1 : last;
  return std::string(lines.substr(command.name.begin, end - command.name.begin));
}

}  // namespace

std::optional<FilterChange> read_filter_change(NcBlock const& block, Token const& token,
                                               ProgramChannel const& channel, ProgramProblems& problems) {
  grammar::NcCommand command = block.commands[*token.command];
  shift(command, block.offset);
  FilterCommandReading reading = channel.read_filter_command(command, block.lines);
  if (!reading.command || !reading.mistakes.empty()) {
    for (auto& mistake : reading.mistakes) {
      Token place = token;
      place.span = {.begin = mistake.span.begin + block.offset, .end = mistake.span.end + block.offset};
      problems.report(block, place, mistake.code, std::move(mistake.message));
    }
    if (reading.mistakes.empty()) problems.refuse(block, token);
    return std::nullopt;
  }
  FilterChange change;
  change.command = *reading.command;
  if (change.command.tolerance) {
    change.tolerance = *change.command.tolerance * units_per_mm * (channel.inch ? mm_per_inch : 1);
  }
  change.text = command.keywords.empty() ? to_text(change.command) : text_of(command, block.lines);
  change.line = token.line;
  return change;
}

}  // namespace axisc::motion
