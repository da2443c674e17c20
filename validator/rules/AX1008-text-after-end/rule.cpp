#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/syntax_problems.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{"text after `Ende` is ignored", "Text nach `Ende` wird nicht mehr gelesen"};
constexpr Sentence related{"the list ends here", "hier endet die Liste"};
constexpr Sentence fix{"make it a comment", "zum Kommentar machen"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

/// Everything from `begin` to the end of the file becomes comments.
std::vector<Edit> comments_from(ListContext const& context, std::uint32_t begin) {
  SourceText const& source = context.source;
  std::vector<Edit> edits;
  std::uint32_t const first = source.position(begin).line;
  for (std::uint32_t line = first; line <= source.line_count(); ++line) {
    Span span = source.line_span(line);
    if (line == first) span.begin = begin;
    std::string_view const text = source.slice(span);
    std::size_t const content = text.find_first_not_of(" \t");
    if (content == std::string_view::npos || text[content] == '#') continue;
    auto const at = span.begin + static_cast<std::uint32_t>(content);
    edits.push_back({.place = place_of(context, {.begin = at, .end = at}), .text = "# "});
  }
  return edits;
}

void describe(Finding& finding, ListContext const& context, grammar::Problem const& problem) {
  finding.message = message(says::headline);
  if (auto const& marker = context.list.tree.end_marker) {
    finding.related.push_back({.place = place_of(context, *marker), .message = message(says::related)});
  }
  finding.fix = Fix{.title = message(says::fix),
                    .edits = comments_from(context, problem.span.begin),
                    .safety = FixSafety::safe};
}

void text_after_end(ListContext const& context, Report& report) {
  report_problems<describe>(context, grammar::ProblemKind::text_after_end, report);
}

}  // namespace

extern constinit Rule const ax1008{
    .code = Code{1008},
    .name = "text-after-end",
    .severity = Severity::warning,
    .check = text_after_end,
};

}  // namespace axisc::validator::checks
