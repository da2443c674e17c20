#include "grammar/program_excerpt.hpp"

#include "grammar/line_splitter.hpp"
#include "support/catch.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <rapidcheck.h>

namespace program_excerpt_test {

using namespace axisc::grammar;

namespace {

void read(ProgramExcerptReader& reader, std::string_view text) {
  LineSplitter splitter(text);
  for (std::string_view line; splitter.next(line);) reader.line(line);
  reader.finish();
}

/// Lines of which some are commands, comments, and blocks that go on.
rc::Gen<std::string> some_program() {
  auto const line = rc::gen::element<std::string>(
      "N10 G01 X1 Y2", "#FILTER ON [ORDER=20]", "(#FILTER ON [ORDER=999])", "#FILTER ON \\", "[ORDER=20] \\",
      "  [SHARE=5]", "G01 \\", "X1 \\", "; axisc: allow AX5002", "#COMMENT BEGIN", "#COMMENT END", "",
      "#TIME 1", "#VIB GUARD ON [MODE=7]", "#FILTER ON [ORDER=", "X1 (axisc: allow AX5001) \\",
      "(only this)");
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(line),
                      [](std::vector<std::string> const& lines) {
                        std::string text;
                        for (std::string const& each : lines) text += each + "\n";
                        return text;
                      });
}

}  // namespace

TEST_CASE("only the lines with commands and with comments for this program are kept") {
  ProgramExcerptReader reader;
  read(reader,
       "%MAIN\nN1 G01 X1\n#FILTER ON [ORDER=20]\nX1 \\\nY1\n(#FILTER OFF)\n#FILTER \\\n(gap)\nOFF\n"
       "X5 ; axisc: allow AX5002\nM30\n");
  CHECK(reader.bytes() == "#FILTER ON [ORDER=20]\n#FILTER \\\n(gap)\nOFF\nX5 ; axisc: allow AX5002\n");
  CHECK(reader.numbers() == std::vector<std::uint32_t>{3, 7, 8, 9, 10});
  CHECK(reader.program().lines == 11);
  REQUIRE(reader.program().commands.size() == 2);
  CHECK(reader.program().commands[1].line == 7);
  REQUIRE(reader.program().directives.size() == 1);
  CHECK(reader.program().directives[0].line == 10);
}

TEST_CASE("an excerpt says what the whole program says") {
  CHECK(rc::check([] {
    std::string const text = *some_program();
    NcProgram const whole = parse_nc_program(text, 0);
    ProgramExcerptReader reader;
    read(reader, text);
    NcProgram const& part = reader.program();
    RC_ASSERT(part.lines == whole.lines);
    RC_ASSERT(part.commands.size() == whole.commands.size());
    std::string_view const kept = reader.bytes();
    auto const same = [&](axisc::Span in_part, axisc::Span in_whole) {
      return kept.substr(in_part.begin, in_part.size()) ==
             std::string_view(text).substr(in_whole.begin, in_whole.size());
    };
    for (std::size_t i = 0; i < whole.commands.size(); ++i) {
      RC_ASSERT(part.commands[i].line == whole.commands[i].line);
      RC_ASSERT(part.commands[i].keywords.size() == whole.commands[i].keywords.size());
      RC_ASSERT(same(part.commands[i].name, whole.commands[i].name));
      for (std::size_t k = 0; k < whole.commands[i].keywords.size(); ++k) {
        RC_ASSERT(same(part.commands[i].keywords[k].name, whole.commands[i].keywords[k].name));
        RC_ASSERT(same(part.commands[i].keywords[k].value, whole.commands[i].keywords[k].value));
      }
      RC_ASSERT(part.commands[i].problem.has_value() == whole.commands[i].problem.has_value());
      if (whole.commands[i].problem) {
        RC_ASSERT(same(part.commands[i].problem->span, whole.commands[i].problem->span));
      }
    }
    RC_ASSERT(part.directives.size() == whole.directives.size());
    for (std::size_t i = 0; i < whole.directives.size(); ++i) {
      RC_ASSERT(part.directives[i].line == whole.directives[i].line);
      RC_ASSERT(same(part.directives[i].comment, whole.directives[i].comment));
    }
  }));
}

}  // namespace program_excerpt_test
