#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/sentences.hpp"

namespace axisc::validator::checks::ax2007::says {

constexpr Sentence headline{"`{value}` is not a valid value for `{parameter}`",
                            "`{value}` ist kein gültiger Wert für `{parameter}`"};
constexpr Sentence reaction{"it does not know the value", "sie kennt den Wert nicht"};

}  // namespace axisc::validator::checks::ax2007::says

namespace axisc::validator::checks::ax2007 {
namespace {

void describe(Finding& finding, Line const& line) {
  schema::Parameter const& parameter = *line.line_value().row;
  std::string const value = line.text(line.line_value().text);
  finding.message = message_of(says::headline, Argument{"value", value}, Argument{"parameter", line.name()});
  finding.notes.push_back(
      message_of(validator::says::parameter_values, Argument{"values", allowed_values(parameter)}));
  if (parameter.symbols.empty()) {
    finding.control.reset();  // its reaction to an unknown number is not documented
  } else {
    set_reaction(finding, says::reaction);
  }
  std::vector<std::string_view> const suggestions = schema::suggest_symbols(parameter, value);
  for (std::string_view const suggestion : suggestions) {
    finding.help.push_back(
        message_of(validator::says::parameter_did_you_mean, Argument{"suggestion", std::string(suggestion)}));
  }
  if (suggestions.empty()) return;
  std::string const best(suggestions.front());
  finding.fix = replace_by(line.place(line.line_value().text), best,
                           message_of(validator::says::parameter_fix, Argument{"replacement", best}));
}

/// One of the words that `|` joins is nearly one of the parameter's.
bool is_misspelt(Line const& line) {
  std::string const value = line.text(line.line_value().text);
  std::string_view rest = value;
  while (true) {
    std::size_t const bar = rest.find('|');
    std::string_view const word = ascii::trimmed(rest.substr(0, bar));
    bool const is_known = schema::read_symbol(*line.line_value().row, word).symbol != nullptr;
    if (!is_known && !schema::suggest_symbols(*line.line_value().row, word).empty()) return true;
    if (bar == std::string_view::npos) return false;
    rest.remove_prefix(bar + 1);
  }
}

void unknown_symbol(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (line.line_value().status != ReadingStatus::unknown_symbol) return;
    Reported& reported = report_line<describe>(report, line, line.line_value().text);
    // The documents of other kinds of lists do not know every word.
    bool const is_certain = context.list.kind == configuration::ListKind::axis || is_misspelt(line);
    if (!is_certain) reported.severity = Severity::note;
  });
}

}  // namespace

extern constinit Rule const rule{
    .control = "2021",
    .about =
        [](schema::Parameter const& parameter) {
          return parameter.is_enumeration() || !parameter.number_names.empty();
        },
    .precedence = Precedence::before_family,
    .check = unknown_symbol,
};

}  // namespace axisc::validator::checks::ax2007
