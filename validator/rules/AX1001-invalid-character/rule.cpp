#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

#include <array>
#include <cstdio>

namespace axisc::validator::says {

constexpr Sentence headline{"the character {character} is not allowed in a list",
                            "das Zeichen {character} ist in einer Liste nicht erlaubt"};
constexpr Sentence undefined{"the byte {character} is not a character, neither in UTF-8 nor in windows-1252",
                             "das Byte {character} ist kein Zeichen, weder in UTF-8 noch in windows-1252"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

std::string hexadecimal(char const* format, unsigned char byte) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), format, byte);
  return text.data();
}

void describe(Finding& finding, ListContext const& context, grammar::Problem const& problem) {
  auto const byte = static_cast<unsigned char>(context.source.slice(problem.span).front());
  bool const undefined = byte >= 0x80 && context.source.encoding() == Encoding::windows_1252;
  std::string const shown = undefined     ? hexadecimal("0x%02X", byte)
                            : byte < 0x80 ? hexadecimal("U+%04X", byte)
                                          : "U+0080";
  finding.message = message(undefined ? says::undefined : says::headline, {{"character", shown}});
}

void invalid_character(ListContext const& context, Report& report) {
  report_problems<describe>(context, grammar::ProblemKind::invalid_character, report);
}

}  // namespace

extern constinit Rule const ax1001{
    .code = Code{1001},
    .name = "invalid-character",
    .check = invalid_character,
};

}  // namespace axisc::validator::checks
