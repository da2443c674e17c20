#include "validator/engine/rule.hpp"

#include "validator/rules/end_marker.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

namespace axisc::validator::checks::ax1002::says {

constexpr Sentence headline{"a line begins with a parameter name, a comment or `Ende`",
                            "eine Zeile beginnt mit einem Parameternamen, einem Kommentar oder `Ende`"};
constexpr Sentence sign{"no `{sign}` between name and value", "kein `{sign}` zwischen Name und Wert"};
constexpr Sentence sign_fix{"write a blank instead", "stattdessen ein Leerzeichen schreiben"};
constexpr Sentence reaction{"it ignores the line", "sie übergeht die Zeile"};
constexpr Sentence fix{"make it a comment", "zum Kommentar machen"};
constexpr Sentence help{
    "put `#` in front of a comment; write an assignment as name, blank, value",
    "vor einen Kommentar `#` setzen; eine Zuweisung als Name, Leerzeichen, Wert schreiben"};

}  // namespace axisc::validator::checks::ax1002::says

namespace axisc::validator::checks::ax1002 {
namespace {

/// How other languages open a comment that takes the rest of the line.
bool opens_foreign_comment(std::string_view word) {
  for (std::string_view const opener : {";", "//", "/*", "(", "*", "--", "'"}) {
    if (word.substr(0, opener.size()) == opener) return true;
  }
  return false;
}

constexpr std::string_view signs = "=:";

void describe_sign(Finding& finding, ListContext const& context, std::uint32_t name_end, std::uint32_t sign) {
  SourceText const& source = context.source;
  finding.message = message(says::sign, {{"sign", source.utf8({.begin = sign, .end = sign + 1})}});
  Span const line = source.line_span(source.position(sign).line);
  std::string_view const after = source.slice({.begin = sign + 1, .end = line.end});
  std::size_t const blanks = after.find_first_not_of(" \t");
  if (blanks == std::string_view::npos) return;
  Span const gap{.begin = name_end, .end = sign + 1 + static_cast<std::uint32_t>(blanks)};
  finding.fix = replace_by(place_of(context, gap), " ", message(says::sign_fix));
}

/// The sign that ends a known name, in `filter[0].order=2`.
std::optional<std::uint32_t> sign_behind_name(ListContext const& context, Span word) {
  std::string_view const text = context.source.slice(word);
  std::size_t const at = text.find_first_of(signs);
  if (at == std::string_view::npos || context.list.catalogue.find(text.substr(0, at)).row == nullptr) {
    return std::nullopt;
  }
  return word.begin + static_cast<std::uint32_t>(at);
}

void describe(Finding& finding, ListContext const& context, grammar::Problem const& problem) {
  if (describe_end_marker(finding, context, problem)) return;
  if (auto const sign = sign_behind_name(context, problem.span)) {
    return describe_sign(finding, context, *sign, *sign);
  }
  finding.message = message(says::headline);
  set_reaction(finding, says::reaction);
  if (!opens_foreign_comment(context.source.slice(problem.span))) {
    finding.help.push_back(message(says::help));
    return;
  }
  Span const before{.begin = problem.span.begin, .end = problem.span.begin};
  finding.fix = replace_by(place_of(context, before), "# ", message(says::fix), FixSafety::safe);
}

/// `filter[0].order = 2`: the sign is where the value should be.
void describe_separate(Finding& finding, Line const& line) {
  describe_sign(finding, line.context, line.assignment().name.end, line.assignment().value.begin);
}

void expected_name(ListContext const& context, Report& report) {
  report_problems<describe>(context, grammar::ProblemKind::expected_name, report);
  for_each_doubtful(context, [&](Line const& line) {
    std::uint32_t const at = line.assignment().value.begin;
    Span const sign{.begin = at, .end = at + 1};
    if (signs.find(context.source.slice(sign)) == std::string_view::npos) return;
    if (line.line_value().status == ReadingStatus::value) return;
    report_line<describe_separate>(report, line, sign);
  });
}

}  // namespace

extern constinit Rule const rule{
    .check = expected_name,
};

}  // namespace axisc::validator::checks::ax1002
