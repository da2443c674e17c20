#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

namespace axisc::validator::checks::ax1009::says {

constexpr Sentence headline{"after a symbol only `(` opens a comment",
                            "nach einem Symbol beginnt ein Kommentar nur mit `(`"};
constexpr Sentence string{"in a string only `(` opens a comment",
                          "in einer Zeichenkette beginnt ein Kommentar nur mit `(`"};
constexpr Sentence reaction{"it reads `{value}`", "sie liest `{value}`"};
constexpr Sentence fix{"open the comment with `(`", "den Kommentar mit `(` beginnen"};

}  // namespace axisc::validator::checks::ax1009::says

namespace axisc::validator::checks::ax1009 {
namespace {

void describe(Finding& finding, Line const& line) {
  Span const trouble = line.line_value().trouble;
  bool const is_symbol = !line.line_value().row->symbols.empty();
  finding.message = message(is_symbol ? says::headline : says::string);
  std::string const value = line.text({.begin = line.assignment().value.begin, .end = trouble.end});
  set_reaction(finding, says::reaction, {{"value", value}}, is_symbol ? "" : value);
  if (is_symbol) finding.control->message = "2021";
  Span const before{.begin = trouble.begin, .end = trouble.begin};
  finding.fix = replace_by(line.place(before), "( ", message(says::fix));
}

void comment_in_string(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    Span const trouble = line.line_value().trouble;
    if (!trouble.empty()) report_line<describe>(report, line, trouble);
  });
}

}  // namespace

extern constinit Rule const rule{
    .check = comment_in_string,
};

}  // namespace axisc::validator::checks::ax1009
