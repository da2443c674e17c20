#include "validator/rules/end_marker.hpp"

#include "diagnostics/ascii.hpp"
#include "grammar/lexical.hpp"
#include "schema/edit_distance.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"

namespace axisc::validator::says {

constexpr Sentence end_marker{"`{text}` is not the end marker `Ende`",
                              "`{text}` ist nicht die Endekennung `Ende`"};

}  // namespace axisc::validator::says

namespace axisc::validator {

bool describe_end_marker(Finding& finding, ListContext const& context, grammar::Problem const& problem) {
  std::string const written = context.source.utf8(problem.span);
  std::string const marker = ascii::lower_case(grammar::lexical::end_marker);
  grammar::AxisList const& list = context.list.tree;
  bool const is_last = list.problems.back().line <= problem.line &&
                       (list.assignments.empty() || list.assignments.back().line < problem.line);
  bool const is_alone =
      written == ascii::trimmed(context.source.slice(context.source.line_span(problem.line)));
  if (!is_last || !is_alone || schema::edit_distance(ascii::lower_case(written), marker, 1) > 1) return false;
  std::string const right(grammar::lexical::end_marker);
  finding.message = message(says::end_marker, {{"text", written}});
  finding.fix = replace_by(*finding.place, right, message(says::parameter_fix, {{"replacement", right}}));
  return true;
}

}  // namespace axisc::validator
