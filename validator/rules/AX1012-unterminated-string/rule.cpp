#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

namespace axisc::validator::checks::ax1012::says {

constexpr Sentence headline{"the quotation mark is not closed on this line",
                            "das Anführungszeichen wird in dieser Zeile nicht geschlossen"};
constexpr Sentence fix{"close the quotation mark at the end of the line",
                       "das Anführungszeichen am Zeilenende schließen"};
constexpr Sentence help{"write `\"` at the end of the text, before the comment",
                        "am Ende des Textes, vor dem Kommentar, `\"` schreiben"};

}  // namespace axisc::validator::checks::ax1012::says

namespace axisc::validator::checks::ax1012 {
namespace {

void describe(Finding& finding, ListContext const& context, grammar::Problem const& problem) {
  finding.message = message(says::headline);
  // With a comment on the line the intended end of the string is unknown.
  if (context.source.slice(problem.span).find_first_of("(#*") != std::string_view::npos) {
    finding.help.push_back(message(says::help));
    return;
  }
  Span const behind{.begin = problem.span.end, .end = problem.span.end};
  finding.fix = replace_by(place_of(context, behind), "\"", message(says::fix));
}

void unterminated_string(ListContext const& context, Report& report) {
  report_problems<describe>(context, grammar::ProblemKind::unterminated_string, report);
}

}  // namespace

extern constinit Rule const rule{
    .check = unterminated_string,
};

}  // namespace axisc::validator::checks::ax1012
