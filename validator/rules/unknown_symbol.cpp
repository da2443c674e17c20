#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {
namespace {

/// "LOWPASS (1), HIGHPASS (2)".
std::string allowed_values(schema::Parameter const& parameter) {
  std::string text;
  for (schema::Symbol const& symbol : parameter.symbols) {
    if (!text.empty()) text += ", ";
    text += symbol.word;
    if (symbol.number) text += " (" + std::to_string(*symbol.number) + ")";
  }
  return text;
}

}  // namespace

void checks::unknown_symbol(ListContext const& context, Report& report) {
  for_each_doubtful(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (reading.status != ReadingStatus::unknown_symbol) return;
    schema::Parameter const& parameter = *reading.row;
    std::string const value = context.source.utf8(reading.text);
    Finding& finding = add_at(context, report, assignment, reading, reading.text,
                              message_of(Text::ax2007, Argument{"value", value},
                                         Argument{"parameter", written_name(context, assignment)}));
    finding.notes.push_back(message_of(Text::ax2007_allowed, Argument{"values", allowed_values(parameter)}));
    set_reaction(finding, Text::ax2007_reaction);
    std::vector<std::string_view> const suggestions = schema::suggest_symbols(parameter, value);
    for (std::string_view const suggestion : suggestions) {
      finding.help.push_back(
          message_of(Text::parameter_did_you_mean, Argument{"suggestion", std::string(suggestion)}));
    }
    if (suggestions.empty()) return;
    std::string const best(suggestions.front());
    finding.fix = replace_by(place_of(context, reading.text), best,
                             message(Text::parameter_fix, {{"replacement", best}}));
  });
}

}  // namespace axisc::validator
