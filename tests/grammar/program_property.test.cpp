// What holds for every NC program: the grammar agrees with a plain scanner, spans lie inside the text, and
// who asks for commands alone gets the same ones.
#include "grammar/nc_program.hpp"
#include "grammar/plain_program_scanner.hpp"
#include "grammar/program_trace.hpp"
#include "support/catch.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <rapidcheck.h>

namespace program_property_test {

namespace {

using axisc::Span;
using axisc::grammar::ProgramDetail;
using axisc::test::ProgramTrace;
using axisc::test::trace_program;

/// Pieces of programs that the language tells apart, and some that it should not.
rc::Gen<std::string> piece() {
  return rc::gen::element<std::string>(
      "#FILTER", "#FILTER ON [", "#filter", "#VIB GUARD", "#VIB", "GUARD", "ON", "OFF", "on", "[", "]", "=",
      "ORDER", "ORDER=20", "SHARE = 80", "HSC", "20", "-5", "+", "0.5", ".5", "5.", ".", "1e3", "E-2", "2O",
      "0,5", ",", "P1", "P10", "V.P.A", "V", "[2]", "(", ")", "(a)", ";", "\"", "\"x\"", "\\", "\\\n", "\n",
      "\n", "\r\n", "\r", "N10", "N", "/", "/3", "#COMMENT BEGIN\n", "\n#COMMENT END\n", "#COMMENT", "BEGIN",
      "#CALL AX", "#SET AX", "LINK", "#PUT", "AX", "%L UP", "%", "$IF", "$", "#", "X5", "G01", "X1=", "_",
      " ", " ", " ", "\t", "(axisc: allow AX5006)", "axisc:", "\xE4", std::string(1, '\0'));
}

std::string program_text() {
  std::string text;
  for (std::string const& part : *rc::gen::container<std::vector<std::string>>(piece())) text += part;
  return text;
}

std::string scanned(std::string_view bytes) {
  ProgramTrace trace(bytes);
  axisc::test::scan_nc_program(bytes, trace);
  return trace.text;
}

bool inside(Span span, std::string_view bytes) {
  return span.begin <= span.end && span.end <= bytes.size();
}

/// The lines of a trace that are no words.
std::string without_words(std::string const& trace) {
  constexpr std::string_view kept[] = {"filter <", "vibration-guard <", "axis-exchange <", "other <#",
                                       "directive "};
  std::string result;
  std::size_t begin = 0;
  while (begin < trace.size()) {
    std::size_t const end = trace.find('\n', begin) + 1;
    std::string const line = trace.substr(begin, end - begin);
    std::string const rest = line.substr(line.find(": ") + 2);
    for (std::string_view const head : kept) {
      if (rest.substr(0, head.size()) == head) result += line;
    }
    begin = end;
  }
  return result;
}

TEST_CASE("the grammar of programs agrees with a scanner by hand") {
  REQUIRE(rc::check("pieces in any order", [] {
    std::string const bytes = program_text();
    RC_ASSERT(trace_program(bytes, ProgramDetail::words) == scanned(bytes));
  }));
  REQUIRE(rc::check("any bytes", [](std::string const& bytes) {
    RC_ASSERT(trace_program(bytes, ProgramDetail::words) == scanned(bytes));
  }));
}

TEST_CASE("what is kept of a program") {
  REQUIRE(rc::check("commands alone are the same commands", [] {
    std::string bytes = program_text();
    // A trace of lines cannot show a span with a line end.
    std::string::size_type at = 0;
    while ((at = bytes.find("\\\n", at)) != std::string::npos) bytes.replace(at, 2, "  ");
    RC_ASSERT(trace_program(bytes, ProgramDetail::commands) ==
              without_words(trace_program(bytes, ProgramDetail::words)));
  }));
  REQUIRE(rc::check("spans lie inside the text", [] {
    std::string const bytes = program_text();
    auto const program = axisc::grammar::parse_nc_program(bytes, 0);
    for (auto const& command : program.commands) {
      RC_ASSERT(inside(command.name, bytes));
      RC_ASSERT(bytes[command.name.begin] == '#');
      RC_ASSERT(command.line >= 1U);
      RC_ASSERT(command.line <= program.lines);
      for (auto const& keyword : command.keywords) {
        RC_ASSERT(inside(keyword.name, bytes));
        RC_ASSERT(!keyword.name.empty());
        RC_ASSERT(inside(keyword.value, bytes));
        RC_ASSERT(keyword.name.end <= keyword.value.begin);
      }
      if (command.problem) {
        RC_ASSERT(inside(command.problem->span, bytes));
        RC_ASSERT(!command.problem->span.empty());
      }
    }
  }));
}

}  // namespace

}  // namespace program_property_test
