#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/sentences.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::validator::checks::ax2007::says {

constexpr Sentence headline{"`{value}` is not a valid value for `{parameter}`",
                            "`{value}` ist kein gültiger Wert für `{parameter}`"};
constexpr Sentence reaction{"it does not know the value", "sie kennt den Wert nicht"};

}  // namespace axisc::validator::checks::ax2007::says

namespace axisc::validator::checks::ax2007 {
namespace {

/// The words that `|` joins in the value of a line, or the value itself.
std::vector<Span> words_of(Line const& line) {
  Span const whole = line.line_value().text;
  std::string_view const value = line.context.source.slice(whole);
  std::vector<Span> words;
  for (std::size_t begin = 0; begin <= value.size();) {
    std::size_t const end = std::min(value.find('|', begin), value.size());
    std::string_view const word = ascii::trimmed(value.substr(begin, end - begin));
    auto const at = whole.begin + static_cast<std::uint32_t>(word.data() - value.data());
    words.push_back({.begin = at, .end = at + static_cast<std::uint32_t>(word.size())});
    begin = end + 1;
  }
  return words;
}

bool is_known(Line const& line, Span word) {
  return schema::read_symbol(*line.line_value().row, line.text(word)).symbol != nullptr;
}

void describe(Finding& finding, Line const& line) {
  schema::Parameter const& parameter = *line.line_value().row;
  std::vector<Span> const words = words_of(line);
  auto const unknown =
      std::find_if(words.begin(), words.end(), [&line](Span word) { return !is_known(line, word); });
  bool const is_word = unknown != words.end() && !unknown->empty();
  Span const wrong = is_word ? *unknown : line.line_value().text;
  std::string const value = line.text(wrong);
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
  finding.fix = replace_by(line.place(wrong), best,
                           message_of(validator::says::parameter_fix, Argument{"replacement", best}));
}

/// One of the words is nearly one of the parameter's.
bool is_misspelt(Line const& line) {
  std::vector<Span> const words = words_of(line);
  return std::any_of(words.begin(), words.end(), [&line](Span word) {
    return !is_known(line, word) && !schema::suggest_symbols(*line.line_value().row, line.text(word)).empty();
  });
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
