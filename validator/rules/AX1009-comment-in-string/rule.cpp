#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

namespace axisc::validator::checks {
namespace {

void describe(Finding& finding, Line const& line) {
  Span const trouble = line.reading().trouble;
  bool const is_symbol = !line.reading().row->symbols.empty();
  finding.message = message(is_symbol ? Text::ax1009 : Text::ax1009_string);
  std::string const value = line.text({.begin = line.assignment().value.begin, .end = trouble.end});
  set_reaction(finding, Text::ax1009_reaction, {{"value", value}}, is_symbol ? "" : value);
  if (is_symbol) finding.control->message = "2022";
  Span const before{.begin = trouble.begin, .end = trouble.begin};
  finding.fix = replace_by(line.place(before), "( ", message(Text::ax1009_fix));
}

void comment_in_string(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    Span const trouble = line.reading().trouble;
    if (!trouble.empty()) report_line<describe>(report, line, trouble);
  });
}

}  // namespace

extern constinit Rule const ax1009{
    .code = Code{1009},
    .name = "comment-in-string",
    .check = comment_in_string,
};

}  // namespace axisc::validator::checks
