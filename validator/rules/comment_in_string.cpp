#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {

void checks::comment_in_string(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (reading.trouble.empty()) return;
    bool const symbol = !reading.row->symbols.empty();
    Finding& finding = add_at(context, report, assignment, reading, reading.trouble,
                              message(symbol ? Text::ax1009 : Text::ax1009_string));
    Span const read{.begin = assignment.value.begin, .end = reading.trouble.end};
    std::string const value = context.source.utf8(read);
    set_reaction(finding, Text::ax1009_reaction, {{"value", value}}, symbol ? "" : value);
    if (symbol) finding.control->message = "2022";
    Span const before{.begin = reading.trouble.begin, .end = reading.trouble.begin};
    finding.fix = replace_by(place_of(context, before), "( ", message(Text::ax1009_fix));
  });
}

}  // namespace axisc::validator
