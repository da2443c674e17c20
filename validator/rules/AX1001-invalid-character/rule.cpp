#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "diagnostics/unusual_character.hpp"
#include "diagnostics/utf8.hpp"
#include "diagnostics/windows_1252.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

#include <array>
#include <cstdio>

namespace axisc::validator::checks::ax1001::says {

constexpr Sentence headline{"the character {character} is not allowed in a list",
                            "das Zeichen {character} ist in einer Liste nicht erlaubt"};
constexpr Sentence undefined{"the byte {character} is not a character, neither in UTF-8 nor in windows-1252",
                             "das Byte {character} ist kein Zeichen, weder in UTF-8 noch in windows-1252"};

constexpr Sentence unusual{"{character} in a name or value", "{character} in einem Namen oder Wert"};
constexpr Sentence fix{"write `{replacement}`", "`{replacement}` schreiben"};
constexpr Sentence remove{"remove it", "es entfernen"};
constexpr Sentence help{"delete it, or save the file again as UTF-8 or windows-1252",
                        "es löschen, oder die Datei neu als UTF-8 oder windows-1252 speichern"};
constexpr Sentence help_line_end{
    "where it was meant to end a line, save the file again with LF or CR LF as line ends; otherwise delete "
    "it",
    "wo es eine Zeile beenden soll, die Datei neu mit LF oder CR LF als Zeilenenden speichern; sonst es "
    "löschen"};

}  // namespace axisc::validator::checks::ax1001::says

namespace axisc::validator::checks::ax1001 {
namespace {

std::string hexadecimal(char const* format, unsigned byte) {
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
  // Deleting those of a file of an old Macintosh would make one line of it.
  finding.help.push_back(message(byte == '\r' ? says::help_line_end : says::help));
}

/// Calls `visit(character, span)` for the characters of a token that look like others.
template <typename Visit>
void for_each_unusual(SourceText const& source, Span token, Visit visit) {
  while (!token.empty()) {
    std::string_view const text = source.slice(token);
    DecodedCharacter character{.value = static_cast<unsigned char>(text.front()), .size = 1};
    if (character.value >= 0x80) {
      if (source.encoding() == Encoding::windows_1252) {
        character.value = decode_windows_1252(text.front());
      } else {
        character = decode_utf8(text);
      }
      Span const span{.begin = token.begin, .end = token.begin + static_cast<std::uint32_t>(character.size)};
      if (auto const* const unusual = find_unusual(character.value)) visit(*unusual, span);
    }
    token.begin += static_cast<std::uint32_t>(character.size);
  }
}

/// The first of a token; empty where it has none.
Span first_unusual(SourceText const& source, Span token) {
  Span first;
  for_each_unusual(source, token, [&first](UnusualCharacter const&, Span span) {
    if (first.empty()) first = span;
  });
  return first;
}

void describe_unusual(Finding& finding, ListContext const& context, Span token) {
  Fix fix;
  std::string repaired;
  std::uint32_t copied = token.begin;
  for_each_unusual(context.source, token, [&](UnusualCharacter const& unusual, Span span) {
    if (fix.edits.empty()) {
      std::string const shown =
          hexadecimal("U+%04X", static_cast<unsigned>(unusual.code)) + " " + std::string(unusual.name);
      finding.message = message(says::unusual, {{"character", shown}});
    }
    fix.edits.push_back({.place = place_of(context, span), .text = std::string(unusual.instead)});
    repaired += context.source.utf8({.begin = copied, .end = span.begin});
    repaired += unusual.instead;
    copied = span.end;
  });
  repaired += context.source.utf8({.begin = copied, .end = token.end});
  repaired = ascii::trimmed(repaired);
  fix.title = repaired.empty() ? message(says::remove) : message(says::fix, {{"replacement", repaired}});
  finding.fix = std::move(fix);
}

/// In comments and in strings every character is allowed; elsewhere it is the mistake.
void invalid_character(ListContext const& context, Report& report) {
  report_problems<describe>(context, grammar::ProblemKind::invalid_character, report);
  for (grammar::Problem const& problem : context.list.tree.problems) {
    if (problem.kind != grammar::ProblemKind::expected_name) continue;
    Span const first = first_unusual(context.source, problem.span);
    if (first.empty()) continue;
    report.later(place_of(context, first), [&context, &problem](Finding& finding) {
      describe_unusual(finding, context, problem.span);
    });
  }
  for_each_doubtful(context, [&](Line const& line) {
    LineValue const& line_value = line.line_value();
    if (!line_value.row_known() || line_value.status == ReadingStatus::value) return;
    Span const first = first_unusual(context.source, line.assignment().value);
    if (first.empty()) return;
    report.later(line.place(first), [line](Finding& finding) {
      name_parameter(finding, line);
      describe_unusual(finding, line.context, line.assignment().value);
    });
  });
}

}  // namespace

extern constinit Rule const rule{
    .check = invalid_character,
};

}  // namespace axisc::validator::checks::ax1001
