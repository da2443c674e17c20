#include "grammar/program_trace.hpp"

#include "grammar/line_splitter.hpp"

#include <array>
#include <cstddef>

namespace axisc::test {
namespace {

using namespace grammar;

std::string_view name_of(CommandKind kind) {
  constexpr std::array<std::string_view, 4> names = {"filter", "vibration-guard", "axis-exchange", "other"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string_view name_of(KeywordValue kind) {
  constexpr std::array<std::string_view, 6> names = {"none", "missing",  "integer",
                                                     "real", "variable", "malformed"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string_view name_of(CommandProblemKind kind) {
  constexpr std::array<std::string_view, 4> names = {"letter-case", "unexpected-text", "expected-keyword",
                                                     "unclosed-bracket"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string_view name_of(WordKind kind) {
  constexpr std::array<std::string_view, 9> names = {"skip", "block-number", "program", "control", "address",
                                                     "name", "number",       "text",    "other"};
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace

std::string ProgramTrace::shown(Span span) const {
  return "<" + std::string(bytes_.substr(span.begin, span.size())) + ">";
}

void ProgramTrace::word(Word const& word) {
  text += std::to_string(word.line) + ": " + std::string(name_of(word.kind)) + " " + shown(word.span) + "\n";
}

void ProgramTrace::command(NcCommand command) {
  text +=
      std::to_string(command.line) + ": " + std::string(name_of(command.kind)) + " " + shown(command.name);
  if (command.command_switch == CommandSwitch::on) text += " on";
  if (command.command_switch == CommandSwitch::off) text += " off";
  for (Keyword const& keyword : command.keywords) {
    text += " " + shown(keyword.name);
    if (keyword.kind == KeywordValue::none) continue;
    text += "=" + std::string(name_of(keyword.kind)) + " " + shown(keyword.value);
  }
  if (command.problem) {
    text += " ! " + std::string(name_of(command.problem->kind)) + " " + shown(command.problem->span);
  }
  text += "\n";
}

void ProgramTrace::directive(Directive const& directive) {
  text += std::to_string(directive.line) + ": directive " + (directive.whole_line ? "alone " : "") +
          shown(directive.comment) + "\n";
}

std::string trace_program(std::string_view bytes, ProgramDetail detail) {
  ProgramTrace trace(bytes);
  ProgramReader reader(trace, detail);
  LineSplitter splitter(bytes);
  for (std::string_view line; splitter.next(line);) {
    // A copy: the reader may not lean on a line once it has seen it.
    std::string const copy(line);
    reader.line(copy, static_cast<std::uint32_t>(line.data() - bytes.data()));
  }
  reader.finish();
  return trace.text;
}

std::string trace_command(std::string_view text) {
  auto const command = parse_nc_command(text);
  if (!command) return "no command\n";
  ProgramTrace trace(text);
  trace.command(*command);
  return trace.text;
}

}  // namespace axisc::test
